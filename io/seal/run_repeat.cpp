#include "io/seal/run_repeat.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/base/build.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/site_reader.h"
#include "io/case/terrain_reader.h"
#include "io/fe/fe_reader.h"
#include "io/site/input_files.h"
#include "io/site/place_check.h"

namespace rubble::io {

namespace {

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Compares the frames of a run as it is made with those that were recorded, bit by bit. Keeps nothing but the first difference.
class FrameComparison : public TrajectorySink {
public:
    explicit FrameComparison(const TrajectoryReader& recorded) : m_recorded(recorded) {}

    void begin(const RunDescription&) override {}
    void addBodies(std::span<const BodyRecord>, std::span<const Carrier>) override {}
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow&) override {}
    void finish(const SimulationResult&) override {}

    const Message& firstDifference() const { return m_difference; }
    std::size_t frames() const { return m_frames; }

private:
    const TrajectoryReader& m_recorded;
    std::size_t m_frames = 0;
    Message m_difference;
};

void FrameComparison::commit(const TrajectoryFrame& frame) {
    const std::size_t i = m_frames++;
    if (!m_difference.empty() || i >= m_recorded.frameCount()) {
        return;
    }
    const auto recorded = m_recorded.frame(i);
    if (!sameBits(recorded->time, frame.time) || recorded->bodies() != frame.bodies()) {
        m_difference = {"io.run.repeat_frames",
                        "The first difference is at t = {0} s: the frames have other times or another number of bodies.",
                        {frame.time}};
        return;
    }
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const bool same = std::equal(frame.positions[b].data(), frame.positions[b].data() + 3, recorded->positions[b].data()) &&
                          std::equal(frame.orientations[b].coeffs().data(), frame.orientations[b].coeffs().data() + 4,
                                     recorded->orientations[b].coeffs().data());
        if (!same) {
            const auto distance = static_cast<double>((frame.positions[b] - recorded->positions[b]).norm());
            m_difference = {
                "io.run.repeat_place", "The first difference is at t = {0} s: body {1} is {2} m away.", {frame.time, b, distance}};
            return;
        }
    }
}

std::string figureText(std::size_t number) {
    return englishInteger(static_cast<std::int64_t>(number));
}

}  // namespace

Inputs openRunInputs(const RunOrigin& origin, Findings& place, Findings& terrain, const Execution& execution) {
    Inputs inputs;
    inputs.fe = openFe(origin.fePath, origin.scenario.import, origin.frame, execution);
    inputs.frame = inputs.fe->contents().frame;
    place.append(checkPlace(inputs.frame, origin.site));
    if (!origin.terrainPath.empty()) {
        const TerrainInput read = openTerrain(origin.terrainPath, inputs.frame, boundsAtRest(inputs.fe->mesh()), execution,
                                              origin.site, origin.terrainRead);
        inputs.terrain = read.grid;
        terrain.append(read.findings);
        if (!origin.surroundings.empty()) {
            inputs.terrain = raisedTerrain(*inputs.terrain, origin.surroundings, inputs.frame, origin.site, execution);
        }
    }
    return inputs;
}

RunOrigin originInCase(const RunReader& run, const std::string& casePath, const Case& theCase, const Execution& execution) {
    RunOrigin origin = run.origin();
    const auto placeOf = [&](InputRole role, const std::string& sha256) {
        for (const CaseInput& input : theCase.inputs) {
            const std::string path = inputPath(casePath, input);
            std::error_code ignored;
            if (input.role == role && std::filesystem::exists(path, ignored) && digestOfInput(path, role, execution).is(sha256)) {
                return path;
            }
        }
        throw UsageError(
            Message{
                "io.run.not_of_case", "{0} stands on a file that the case does not have now: SHA-256 {1}", {run.path(), sha256}},
            Message{"io.run.not_of_case.remedy", "Find the file, and save the case with it.", {}});
    };
    origin.fePath = placeOf(InputRole::Fe, origin.feSha256);
    if (!origin.terrainPath.empty()) {
        origin.terrainPath = placeOf(InputRole::Terrain, origin.terrainSha256);
    }
    for (RecordedInput& mesh : origin.surroundings) {
        mesh.path = placeOf(InputRole::Surroundings, mesh.sha256);
    }
    return origin;
}

RunRepeat repeatRun(const RunReader& recorded, const Inputs& inputs, const Execution& execution) {
    const RunOrigin& origin = recorded.origin();
    FrameComparison comparison(recorded);
    const Results again = run(inputs, origin.scenario, Stage::Simulation, {}, &comparison, execution);
    const SimulationResult& before = *recorded.result();
    const SimulationResult& now = *again.simulation;
    RunRepeat repeat;
    repeat.figures = {{"build", origin.build, std::string(buildText())},
                      {"fingerprint", origin.fingerprint.hex(), stageKey(inputs, origin.scenario, Stage::Simulation).hex()},
                      {"clusters", figureText(recorded.clustering()->list.size()), figureText(again.clustering->list.size())},
                      {"frames", figureText(recorded.frameCount()), figureText(comparison.frames())},
                      {"steps", englishInteger(before.steps), englishInteger(now.steps)}};
    // Runs of before the monitor know of no effects either.
    if (!before.effects.empty()) {
        repeat.figures.push_back(
            {"health breaches", figureText(before.health.breaches.size()), figureText(now.health.breaches.size())});
    }
    repeat.figures.push_back({"trajectory hash", before.trajectoryHash.hex(), now.trajectoryHash.hex()});
    repeat.equal = repeat.figures.back().same();
    repeat.firstDifference = comparison.firstDifference();
    return repeat;
}

}  // namespace rubble::io
