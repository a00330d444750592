#include "io/run/run_history.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/simulation/health/passed_limits.h"
#include "io/base/files.h"
#include "io/json/json_document.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_file.h"
#include "io/run/run_json.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

// A hundred thousand runs are smaller.
constexpr JsonKind historyKind{"rubble-run-history", 1, std::uintmax_t{128} << 20};

std::optional<HealthGrade> gradeFrom(const JsonCursor& grade) {
    if (grade.value().is_null()) {
        return std::nullopt;
    }
    const std::string name = grade.text();
    for (const HealthGrade each : {HealthGrade::Notice, HealthGrade::Finding, HealthGrade::Tainted}) {
        if (healthGradeName(each) == name) {
            return each;
        }
    }
    grade.fail("notice, finding or tainted");
}

/// A run that lies in the folder of its case is named from there, so that the folder may be moved.
std::string fileFrom(const fs::path& folder, const std::string& file) {
    const fs::path from = fs::path(file).lexically_relative(folder);
    return file.empty() || from.empty() || *from.begin() == ".." ? file : from.string();
}

nlohmann::json entryJson(const RunEntry& run, const fs::path& folder) {
    return {{"when", run.when},
            {"scenario", run.scenarioId},
            {"scenario_name", run.scenarioName},
            {"fingerprint", run.fingerprint.hex()},
            {"fe_sha256", run.feSha256},
            {"build", run.build},
            {"live", run.live},
            {"complete", run.complete},
            {"interrupted", run.interrupted},
            {"wall_s", jsonNumber(run.wallSeconds)},
            {"fragments", run.fragments},
            {"bodies", run.bodies},
            {"end_s", jsonNumber(run.endTime)},
            {"asleep_at_end", jsonNumber(run.asleepAtEnd)},
            {"ms_per_step", jsonNumber(run.msPerStep)},
            {"max_speed_m_s", jsonNumber(run.maxSpeed)},
            {"bulking_factor", jsonNumber(run.bulkingFactor)},
            {"energy_drift", jsonNumber(run.energyDrift)},
            {"breaches", run.breaches},
            {"grade", run.breaches > 0 && run.grade ? nlohmann::json(std::string(healthGradeName(*run.grade))) : nlohmann::json()},
            {"acknowledged", run.acknowledged},
            {"trajectory_hash", run.trajectoryHash.hex()},
            {"file", fileFrom(folder, run.file)}};
}

RunEntry entryFrom(const JsonCursor& entry, const fs::path& folder) {
    RunEntry run;
    run.when = entry["when"].text();
    run.scenarioId = entry["scenario"].text();
    run.scenarioName = entry["scenario_name"].text();
    run.fingerprint = digestFromJson(entry["fingerprint"]);
    run.feSha256 = entry["fe_sha256"].text();
    run.build = entry["build"].text();
    run.live = entry["live"].flag();
    run.complete = entry["complete"].flag();
    run.wallSeconds = entry["wall_s"].anyNumber();
    run.fragments = entry["fragments"].integer();
    run.bodies = entry["bodies"].integer();
    run.endTime = entry["end_s"].anyNumber();
    run.asleepAtEnd = entry["asleep_at_end"].anyNumber();
    run.msPerStep = entry["ms_per_step"].anyNumber();
    run.maxSpeed = entry["max_speed_m_s"].anyNumber();
    run.bulkingFactor = entry["bulking_factor"].anyNumber();
    run.energyDrift = entry["energy_drift"].anyNumber();
    run.breaches = entry["breaches"].integer();
    // Earlier versions kept none of these.
    run.interrupted = entry.has("interrupted") && entry["interrupted"].flag();
    run.grade = entry.has("grade") ? gradeFrom(entry["grade"]) : std::nullopt;
    run.acknowledged = entry.has("acknowledged") && entry["acknowledged"].flag();
    run.trajectoryHash = digestFromJson(entry["trajectory_hash"]);
    run.file = entry["file"].text();
    if (!run.file.empty() && fs::path(run.file).is_relative()) {
        run.file = (folder / run.file).lexically_normal().string();
    }
    return run;
}

}  // namespace

std::string runHistoryPath(const std::string& casePath) {
    return casePath + ".runs.json";
}

std::vector<RunEntry> readRunHistory(const std::string& file) {
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(file, failed))) {
        return {};
    }
    const nlohmann::json document = readJsonDocument(file, historyKind);
    const JsonCursor top(document, file);
    std::vector<RunEntry> runs;
    const fs::path folder = fs::absolute(file).parent_path();
    for (const JsonCursor& entry : top["runs"].elements()) {
        runs.push_back(entryFrom(entry, folder));
    }
    return runs;
}

void writeRunHistory(const std::string& file, const std::vector<RunEntry>& runs) {
    nlohmann::json document = {{"format", historyKind.format}, {"version", historyKind.version}, {"runs", nlohmann::json::array()}};
    const fs::path folder = fs::absolute(file).parent_path();
    for (const RunEntry& run : runs) {
        document["runs"].push_back(entryJson(run, folder));
    }
    std::error_code failed;
    fs::create_directories(fs::path(file).parent_path(), failed);
    // Whatever is wrong with the folder is told by the writing.
    writeAtomically(file, [&](std::ostream& out) { out << jsonText(document) << '\n'; });
}

void takeVerdict(RunEntry& run) {
    if (run.breaches == 0) {
        run.grade = HealthGrade::Notice;
        return;
    }
    std::error_code failed;
    if (run.file.empty() || !fs::exists(run.file, failed)) {
        return;
    }
    const bool vouched = fs::exists(acknowledgementPath(run.file), failed);
    run.acknowledged = run.acknowledged && vouched;
    if (run.grade && !vouched) {
        return;
    }
    try {
        const Taint taint = taintOf(*openRun(run.file));
        run.grade = taint.grade;
        run.acknowledged = taint.acknowledgement.has_value();
    } catch (const Error&) {
        // Whoever opens it is told what is wrong with it.
    }
}

}  // namespace rubble::io
