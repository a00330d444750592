#include "io/run/study_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/analysis/accuracy/study_tasks.h"
#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"
#include "io/run/checkpoint_file.h"
#include "io/run/world_record.h"

namespace rubble::io {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int studyVersion = 1;

std::string nameOf(Hasher& hasher) {
    return hasher.finish().hex();
}

void addDamaged(Findings& findings, const Error& error) {
    findings.add({"study.damaged", "What was kept of an earlier study is damaged and is made again.", {}},
                 {"study.damaged.remedy", "Delete the file named, if this is said each time.", {}}, error.what());
}

Digest digestFrom(const JsonCursor& cursor) {
    const std::optional<Digest> digest = digestFromHex(cursor.text());
    if (!digest) {
        cursor.fail("32 lower-case hexadecimal digits");
    }
    return *digest;
}

json costJson(const WorldOrigin& origin, const SettingCost& cost) {
    return {{"version", studyVersion},
            {"world", origin.key.hex()},
            {"machine", origin.machine},
            {"threads", cost.threads},
            {"wall_s", jsonNumber(cost.wallSeconds)},
            {"ms_per_step_mean", jsonNumber(cost.stepMeanMs)},
            {"ms_per_step_worst", jsonNumber(cost.stepWorstMs)},
            {"fps", jsonNumber(cost.fps)},
            {"fps_worst", jsonNumber(cost.fpsWorst)},
            {"others_share", jsonNumber(cost.othersShare)}};
}

json pointJson(const KnownPoint& point) {
    json values = json::object();
    for (std::size_t w = 0; w < predictedCount; ++w) {
        values[std::string(predictedKey(static_cast<Predicted>(w)))] = jsonNumber(point.values[w]);
    }
    return {{"version", studyVersion},      {"scene", point.scene.hex()}, {"machine", point.machine},
            {"threads", point.threads},     {"setting", point.setting},   {"parameters", point.parameters},
            {"fragments", point.fragments}, {"bodies", point.bodies},     {"values", values}};
}

KnownPoint pointFrom(const JsonCursor& cursor) {
    if (cursor["version"].integer() != studyVersion) {
        cursor["version"].fail("version 1");
    }
    KnownPoint point;
    point.scene = digestFrom(cursor["scene"]);
    point.machine = cursor["machine"].text();
    point.threads = static_cast<int>(cursor["threads"].integer());
    point.setting = cursor["setting"].text();
    for (const auto& [key, value] : cursor["parameters"].members()) {
        point.parameters[key] = value.text();
        try {
            Scenario scenario;
            setParameterText(scenario, key, value.text());
        } catch (const UsageError&) {
            value.fail("a value that " + key + " takes");
        }
    }
    point.fragments = cursor["fragments"].integer();
    point.bodies = cursor["bodies"].integer();
    for (std::size_t w = 0; w < predictedCount; ++w) {
        point.values[w] = cursor["values"][predictedKey(static_cast<Predicted>(w))].anyNumber();
    }
    return point;
}

json calibrationJson(const Calibration& calibration) {
    json points = json::array();
    for (const CalibrationPoint& point : calibration.points) {
        points.push_back({{"pile", pileName(point.pile)},
                          {"bodies", point.bodies},
                          {"physics_fps", jsonNumber(point.physicsFps)},
                          {"drawing_fps", jsonNumber(point.drawingFps)},
                          {"live_fps", jsonNumber(point.liveFps)}});
    }
    return {{"version", studyVersion},
            {"machine", calibration.machine},
            {"renderer", calibration.renderer},
            {"build", calibration.build},
            {"threads", calibration.threads},
            {"others_share", jsonNumber(calibration.othersShare)},
            {"target_fps", calibration.target},
            {"complete", calibration.complete},
            {"points", points}};
}

Calibration calibrationFrom(const JsonCursor& cursor) {
    if (cursor["version"].integer() != studyVersion) {
        cursor["version"].fail("version 1");
    }
    Calibration calibration;
    calibration.machine = cursor["machine"].text();
    calibration.renderer = cursor["renderer"].text();
    calibration.build = cursor["build"].text();
    calibration.threads = static_cast<int>(cursor["threads"].integer());
    calibration.othersShare = cursor["others_share"].anyNumber();
    calibration.target = cursor["target_fps"].number();
    calibration.complete = cursor["complete"].flag();
    for (const JsonCursor& row : cursor["points"].elements()) {
        CalibrationPoint point;
        const std::string pile = row["pile"].text();
        if (pile != pileName(PileKind::Typical) && pile != pileName(PileKind::Worst)) {
            row["pile"].fail("typical or worst");
        }
        point.pile = pile == pileName(PileKind::Worst) ? PileKind::Worst : PileKind::Typical;
        point.bodies = row["bodies"].integer();
        if (point.bodies < 1) {
            row["bodies"].fail("a number above zero");
        }
        point.physicsFps = row["physics_fps"].anyNumber();
        point.drawingFps = row["drawing_fps"].anyNumber();
        point.liveFps = row["live_fps"].anyNumber();
        calibration.points.push_back(point);
    }
    return calibration;
}

/// Reads a JSON file that was kept; nothing if there is none or it is damaged, which is told.
template <class From>
auto readKept(const std::string& path, Findings& findings, From from) -> std::optional<decltype(from(std::declval<JsonCursor>()))> {
    const std::optional<std::string> content = contentOf(path);
    if (!content) {
        return {};
    }
    try {
        const json document = parseJson(*content, path);
        return from(JsonCursor(document, path));
    } catch (const ParseError& error) {
        addDamaged(findings, error);
        return {};
    }
}

}  // namespace

std::string StudyFiles::worldPath(const WorldOrigin& origin) const {
    return (fs::path(m_folder) / "worlds" / (origin.key.hex() + ".world")).string();
}

std::string StudyFiles::checkpointPath(const WorldOrigin& origin) const {
    return (fs::path(m_folder) / "checkpoints" / (origin.key.hex() + ".checkpoint")).string();
}

std::string StudyFiles::costPath(const WorldOrigin& origin, int threads) const {
    Hasher hasher;
    hasher.digest(origin.key).text(origin.machine).value(threads);
    return (fs::path(m_folder) / "costs" / (nameOf(hasher) + ".json")).string();
}

std::string StudyFiles::pointPath(const KnownPoint& point) const {
    Hasher hasher;
    hasher.text(point.machine).value(point.threads).value(point.bodies);
    for (const auto& [key, value] : point.parameters) {
        hasher.text(key).text(value);
    }
    return (fs::path(m_folder) / "points" / point.scene.hex() / (nameOf(hasher) + ".json")).string();
}

std::string StudyFiles::calibrationPath(const std::string& machine) const {
    Hasher hasher;
    hasher.text(machine);
    return (fs::path(m_folder) / "calibration" / (nameOf(hasher) + ".json")).string();
}

std::optional<SimulatedWorld> StudyFiles::world(const WorldOrigin& origin, Findings& findings) {
    const std::string path = worldPath(origin);
    const std::optional<std::string> content = contentOf(path);
    if (!content) {
        return {};
    }
    try {
        auto [found, world] = worldFromBytes(*content, path);
        const std::string foreign = foreignPart(origin, found);
        if (!foreign.empty()) {
            findings.add({"study.foreign",
                          "A world that was kept under this name was simulated from something else: it is not compared.",
                          {}},
                         {"study.foreign.remedy", "Nothing needs doing: it is simulated anew.", {}}, path + ": another " + foreign);
            return {};
        }
        if (found.machine != origin.machine) {
            findings.add({"study.other_machine",
                          "A world was simulated on another machine: its debris is compared, its figures of time are not.",
                          {}},
                         {"study.other_machine.remedy", "Delete it to have it simulated here.", {}}, path + ": " + found.machine);
        }
        return std::move(world);
    } catch (const ParseError& error) {
        addDamaged(findings, error);
        return {};
    }
}

void StudyFiles::keep(const WorldOrigin& origin, const SimulatedWorld& world) {
    writeIn(worldPath(origin), worldBytes(origin, world));
    CheckpointFile(checkpointPath(origin)).remove();
}

std::unique_ptr<CheckpointStore> StudyFiles::checkpoints(const WorldOrigin& origin) {
    return std::make_unique<CheckpointFile>(checkpointPath(origin));
}

bool StudyFiles::keeps(const WorldOrigin& origin) {
    Findings ignored;
    return world(origin, ignored).has_value();
}

std::optional<SettingCost> StudyFiles::cost(const WorldOrigin& origin, int threads) {
    Findings ignored;
    return readKept(costPath(origin, threads), ignored, [&](const JsonCursor& cursor) {
        if (cursor["version"].integer() != studyVersion || cursor["world"].text() != origin.key.hex() ||
            cursor["machine"].text() != origin.machine || cursor["threads"].integer() != threads) {
            cursor.fail("the cost of this world on this machine");
        }
        SettingCost cost;
        cost.wallSeconds = cursor["wall_s"].anyNumber();
        cost.stepMeanMs = cursor["ms_per_step_mean"].anyNumber();
        cost.stepWorstMs = cursor["ms_per_step_worst"].anyNumber();
        cost.fps = cursor["fps"].anyNumber();
        cost.fpsWorst = cursor["fps_worst"].anyNumber();
        cost.othersShare = cursor["others_share"].anyNumber();
        cost.threads = threads;
        return cost;
    });
}

void StudyFiles::keep(const WorldOrigin& origin, const SettingCost& cost) {
    writeIn(costPath(origin, cost.threads), costJson(origin, cost).dump(2));
}

std::vector<KnownPoint> StudyFiles::points(const Digest& scene, Findings& findings) const {
    std::vector<fs::path> paths;
    std::error_code ignored;
    for (fs::directory_iterator it(fs::path(m_folder) / "points" / scene.hex(), ignored), end; it != end; it.increment(ignored)) {
        if (it->path().extension() == ".json") {
            paths.push_back(it->path());
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<KnownPoint> points;
    for (const fs::path& path : paths) {
        std::optional<KnownPoint> point = readKept(path.string(), findings, pointFrom);
        if (point && point->scene == scene) {
            points.push_back(std::move(*point));
        }
    }
    return points;
}

void StudyFiles::keep(const KnownPoint& point) {
    const std::string path = pointPath(point);
    KnownPoint merged = point;
    Findings ignored;
    if (const std::optional<KnownPoint> before = readKept(path, ignored, pointFrom)) {
        for (std::size_t w = 0; w < predictedCount; ++w) {
            merged.values[w] = std::isfinite(point.values[w]) ? point.values[w] : before->values[w];
        }
    }
    writeIn(path, pointJson(merged).dump(2));
}

std::optional<Calibration> StudyFiles::calibration(const std::string& machine, Findings& findings) const {
    std::optional<Calibration> found = readKept(calibrationPath(machine), findings, calibrationFrom);
    if (found && found->machine != machine) {
        found.reset();
    }
    return found;
}

void StudyFiles::keep(const Calibration& calibration) {
    writeIn(calibrationPath(calibration.machine), calibrationJson(calibration).dump(2));
}

void keepPoints(StudyFiles& files, AccuracyReport& report) {
    const auto keep = [&](const AccuracyPoint& point) {
        if (!point.done) {
            return;
        }
        try {
            files.keep(knownPoint(point, report));
        } catch (const WorldError& error) {
            report.findings.add({"accuracy.not_kept", "A result could not be kept for a second start.", {}},
                                {"accuracy.not_kept.remedy", "Make room for the cache, or name another folder.", {}}, error.what());
        }
    };
    keep(report.reference);
    std::for_each(report.points.begin(), report.points.end(), keep);
}

}  // namespace rubble::io
