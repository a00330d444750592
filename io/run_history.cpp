#include "io/run_history.h"

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/files.h"
#include "io/run_json.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr const char* formatName = "rubble-run-history";
constexpr std::int64_t formatVersion = 1;
// A hundred thousand runs are smaller.
constexpr std::uintmax_t bytesMax = std::uintmax_t{128} << 20;

nlohmann::json entryJson(const RunEntry& run) {
    return {{"when", run.when},
            {"scenario", run.scenarioId},
            {"scenario_name", run.scenarioName},
            {"fingerprint", run.fingerprint.hex()},
            {"fe_sha256", run.feSha256},
            {"build", run.build},
            {"live", run.live},
            {"complete", run.complete},
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
            {"trajectory_hash", run.trajectoryHash.hex()},
            {"file", run.file}};
}

RunEntry entryFrom(const JsonCursor& entry) {
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
    run.trajectoryHash = digestFromJson(entry["trajectory_hash"]);
    run.file = entry["file"].text();
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
    const std::uintmax_t size = fs::file_size(file, failed);
    std::ifstream in;
    if (!failed && size <= bytesMax) {
        in.open(file, std::ios::binary);
    }
    if (!in.is_open()) {
        throw WorldError({"io.run_history.unreadable", "Cannot read the history of runs {0}", {file}},
                         {"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    const nlohmann::json document = parseJson(std::string(std::istreambuf_iterator<char>(in), {}), file);
    const JsonCursor top(document, file);
    if (top["format"].text() != formatName) {
        top["format"].fail(std::string("\"") + formatName + "\"");
    }
    if (top["version"].integer() != formatVersion) {
        top["version"].fail(std::to_string(formatVersion));
    }
    std::vector<RunEntry> runs;
    for (const JsonCursor& entry : top["runs"].elements()) {
        runs.push_back(entryFrom(entry));
    }
    return runs;
}

void writeRunHistory(const std::string& file, const std::vector<RunEntry>& runs) {
    nlohmann::json document = {{"format", formatName}, {"version", formatVersion}, {"runs", nlohmann::json::array()}};
    for (const RunEntry& run : runs) {
        document["runs"].push_back(entryJson(run));
    }
    std::error_code failed;
    fs::create_directories(fs::path(file).parent_path(), failed);
    // Whatever is wrong with the folder is told by the writing.
    writeAtomically(file, [&](std::ostream& out) { out << jsonText(document) << '\n'; });
}

}  // namespace rubble::io
