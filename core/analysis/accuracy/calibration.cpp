#include "core/analysis/accuracy/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/analysis/accuracy/machine_load.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "core/base/standard_gravity.h"
#include "core/base/unknown.h"
#include "core/fe/block_scene.h"

namespace rubble {

namespace {

constexpr std::int64_t bodiesLeast = 8;
constexpr std::int64_t bodiesMost = 100000;
/// How far beyond the measured numbers of bodies the curve may be read.
constexpr double readBeyond = 1.5;
/// Scatter of a measured rate that is likely before any is seen, as a share.
constexpr double likelyScatter = 0.1;
constexpr double interval = 0.1;  // s, between FE states
constexpr std::size_t states = 31;

/// The logarithms that the curve is fitted to.
std::vector<FitSample> samplesOf(const std::vector<CalibrationPoint>& points, PileKind pile, LiveLoad load) {
    std::vector<FitSample> samples;
    for (const CalibrationPoint& point : points) {
        if (point.pile == pile && point.fps(load) > 0.0 && std::isfinite(point.fps(load))) {
            samples.push_back({{std::log(static_cast<double>(point.bodies))}, std::log(point.fps(load))});
        }
    }
    return samples;
}

std::pair<double, double> rangeOf(const std::vector<FitSample>& samples) {
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end(),
                                                   [](const FitSample& a, const FitSample& b) { return a.at[0] < b.at[0]; });
    return {least->at[0] - std::log(readBeyond), most->at[0] + std::log(readBeyond)};
}

/// One world of the calibration, measured in every way that works here.
class PileMeasurement {
public:
    PileMeasurement(const CalibrationSettings& settings, Calibration& calibration, const Execution& execution)
        : m_settings(settings), m_calibration(calibration), m_execution(execution) {}

    CalibrationPoint measure(PileKind kind, std::int64_t bodies) {
        const auto [inputs, scenario] = pileScene(kind, bodies);
        const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, m_execution);
        const RunDescription description = describeRun(inputs, scenario, results);
        const auto rate = [kind](const LiveRate& live) { return kind == PileKind::Worst ? live.worst : live.mean; };
        CalibrationPoint point;
        point.pile = kind;
        point.bodies = static_cast<std::int64_t>(results.clustering->list.size());
        point.physicsFps = rate(measureLive(description, m_settings.target, {}, m_execution));
        point.drawingFps = unknown;
        point.liveFps = unknown;
        if (m_settings.screen && m_screenWorks) {
            try {
                point.drawingFps = rate(drawingAlone(description));
                point.liveFps = rate(measureLive(description, m_settings.target, m_settings.screen, m_execution));
            } catch (const WorldError& error) {
                m_screenWorks = false;
                m_calibration.findings.add(
                    {"calibration.no_screen", "Nothing can be drawn here: only the physics was measured.", {}}, error.remedy(),
                    error.what());
            }
        }
        return point;
    }

private:
    LiveRate drawingAlone(const RunDescription& description) const {
        RunDescription recorded = description;
        recorded.scenario.simulation.frameRate = 2.0 * m_settings.target;
        recorded.scenario.simulation.settleTime = 0.0;
        const auto trajectory = std::make_shared<MemoryTrajectory>();
        simulate(recorded, *trajectory, m_execution);
        return measureDrawing(recorded, trajectory, m_settings.target, m_settings.screen, m_execution);
    }

    const CalibrationSettings& m_settings;
    Calibration& m_calibration;
    const Execution& m_execution;
    bool m_screenWorks = true;
};

}  // namespace

std::string_view pileName(PileKind kind) {
    return kind == PileKind::Typical ? "typical" : "worst";
}

double CalibrationPoint::fps(LiveLoad load) const {
    return load == LiveLoad::Physics ? physicsFps : load == LiveLoad::Drawing ? drawingFps : liveFps;
}

bool Calibration::disturbed() const {
    return othersShare > MachineLoad::quietBelow;
}

std::optional<FitInterval> Calibration::fps(PileKind pile, LiveLoad load, double bodies) const {
    const std::vector<FitSample> samples = samplesOf(points, pile, load);
    if (samples.size() < 3 || !(bodies > 0.0)) {
        return {};
    }
    const auto [low, high] = rangeOf(samples);
    const double at = std::log(bodies);
    if (at < low || at > high) {
        return {};
    }
    const FitInterval found = IntervalFit(samples, likelyScatter).predict({at}, 0.8);
    return FitInterval{std::exp(found.low), std::exp(found.value), std::exp(found.high)};
}

std::optional<Calibration::BodiesMax> Calibration::bodiesMax(PileKind pile, LiveLoad load, double fpsTarget) const {
    const std::vector<FitSample> samples = samplesOf(points, pile, load);
    if (samples.size() < 3 || !(fpsTarget > 0.0)) {
        return {};
    }
    auto [low, high] = rangeOf(samples);
    const IntervalFit fit(samples, likelyScatter);
    const auto enough = [&](double at) { return fit.predict({at}, 0.8).value >= std::log(fpsTarget); };
    if (enough(high)) {
        return BodiesMax{std::exp(high), true, false};
    }
    if (!enough(low)) {
        return BodiesMax{std::exp(low), false, true};
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (enough(middle) ? low : high) = middle;
    }
    return BodiesMax{std::exp(low), false, false};
}

std::optional<double> Calibration::exponent(PileKind pile, LiveLoad load) const {
    const std::vector<FitSample> samples = samplesOf(points, pile, load);
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const FitSample& sample : samples) {
        n += 1.0;
        x += sample.at[0];
        y -= sample.value;
        xx += sample.at[0] * sample.at[0];
        xy -= sample.at[0] * sample.value;
    }
    const double spread = n * xx - x * x;
    return spread > 1e-12 ? std::optional((n * xy - x * y) / spread) : std::nullopt;
}

std::pair<Inputs, Scenario> pileScene(PileKind kind, std::int64_t bodies) {
    const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(bodies)))));
    const int layers = std::max(2, static_cast<int>(std::lround(static_cast<double>(bodies) / (side * side))));
    blocks::Block block;
    block.cells = {side, side, layers};
    block.size = Vec3(side, side, layers);
    block.density = 2400.0;
    if (kind == PileKind::Typical) {
        // Each layer dies at the state after it met the ground, layer by layer over the first two seconds of a fall.
        const double height = 1.0;
        block.low = Vec3(0, 0, height);
        block.gravity = standardGravity;
        const double fall = height + layers;
        // However high the block is, its births take two seconds: a faster fall for a higher block, as of a taller structure.
        block.velocity = Vec3(0, 0, -std::max(0.0, fall / 2.0 - standardGravity));
        const int perLayer = side * side;
        block.deathState = [=](std::size_t element) {
            const double drop = height + static_cast<double>(element / static_cast<std::size_t>(perLayer));
            const double down = -block.velocity.z();
            const double time = (-down + std::sqrt(down * down + 2.0 * standardGravity * drop)) / standardGravity;
            return std::min(states - 2, static_cast<std::size_t>(std::ceil(time / interval)));
        };
    } else {
        block.low = Vec3(0, 0, 0.05);
        block.deathState = [](std::size_t) { return std::size_t{1}; };
    }
    Inputs inputs;
    inputs.fe = blocks::makeScene({block}, states, interval);
    Scenario scenario;
    scenario.grid.oneBodyPerFragment = true;
    // Cubes in rows would stand on each other for ever.
    scenario.fragments.birthShift = 0.1;
    scenario.simulation.freeze = kind == PileKind::Typical;
    return {std::move(inputs), std::move(scenario)};
}

Calibration calibrate(const CalibrationSettings& settings, const Execution& execution) {
    for (const std::int64_t bodies : settings.bodies) {
        if (bodies < bodiesLeast || bodies > bodiesMost) {
            throw UsageError({"calibration.bodies", "{0} bodies cannot be calibrated with.", {bodies}},
                             {"calibration.bodies.remedy", "Give numbers from {0} to {1}.", {bodiesLeast, bodiesMost}});
        }
    }
    Calibration calibration;
    calibration.machine = settings.machine;
    calibration.build = std::string(buildText());
    calibration.threads = execution.threads();
    calibration.target = settings.target;
    std::vector<std::int64_t> bodies = settings.bodies;
    std::sort(bodies.begin(), bodies.end());
    double all = 0.0;
    for (const std::int64_t n : bodies) {
        all += 2.0 * static_cast<double>(n);
    }
    double before = 0.0;
    const MachineLoad load;
    try {
        // A measurement has several stages; only whole ones move the line on.
        const Execution own([&](const Progress&) {
            execution.report({"analysis.calibration", "measuring this machine", {}}, std::min(0.999, before / all));
        });
        const Execution measuring = own.withThreads(execution.threads());
        PileMeasurement measurement(settings, calibration, measuring);
        for (const std::int64_t n : bodies) {
            for (const PileKind kind : {PileKind::Typical, PileKind::Worst}) {
                calibration.points.push_back(measurement.measure(kind, n));
                before += static_cast<double>(n);
                execution.report({"analysis.calibration", "measuring this machine", {}}, before / all);
            }
        }
        calibration.complete = true;
    } catch (const Cancelled&) {
        // What was measured by now is reported.
    }
    calibration.othersShare = load.othersShare();
    if (calibration.disturbed()) {
        calibration.findings.add({"calibration.disturbed",
                                  "Other programs worked on this machine while it was measured: nothing is predicted from this.",
                                  {}},
                                 {"calibration.disturbed.remedy", "Measure again when the machine is quiet.", {}},
                                 englishNumber(100.0 * calibration.othersShare) + " % of the processors' time");
    }
    const auto drawn = [](const CalibrationPoint& point) { return std::isfinite(point.liveFps); };
    if (settings.renderer && std::any_of(calibration.points.begin(), calibration.points.end(), drawn)) {
        calibration.renderer = settings.renderer();
    }
    return calibration;
}

}  // namespace rubble
