#include "io/case/kept_causes.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/base/files.h"
#include "io/json/json_cursor.h"
#include "io/json/json_document.h"
#include "io/json/json_text.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr JsonKind causesKind{"rubble-causes", 1, std::uintmax_t{16} << 20};

fs::path folderOf(const std::string& file) {
    return fs::absolute(file).parent_path().lexically_normal();
}

/// The case and all that belongs to it may be moved together.
std::string pathBeside(const fs::path& folder, const std::string& path) {
    return fs::path(path).lexically_proximate(folder).generic_string();
}

std::string pathFrom(const fs::path& folder, const JsonCursor& entry) {
    return (folder / entry["path"].text()).lexically_normal().string();
}

EvidenceFile::Kind fileKindFrom(const JsonCursor& holds) {
    using Kind = EvidenceFile::Kind;
    for (const Kind kind : {Kind::Footprint, Kind::Heights, Kind::Surface}) {
        if (holds.text() == evidenceKeyword(kind)) {
            return kind;
        }
    }
    holds.fail("a kind of evidence");
}

std::set<std::string> idsFrom(const JsonCursor& list) {
    std::set<std::string> ids;
    for (const JsonCursor& each : list.elements()) {
        ids.insert(each.text());
    }
    return ids;
}

nlohmann::json timeJson(const KeptCauses::Time& each) {
    const TimeEvidence& time = each.time;
    return {{"time_s", jsonNumber(time.time)},     {"x_m", jsonNumber(time.place.x())},       {"y_m", jsonNumber(time.place.y())},
            {"radius_m", jsonNumber(time.radius)}, {"accuracy_s", jsonNumber(time.accuracy)}, {"used", each.used}};
}

KeptCauses::Time timeFrom(const JsonCursor& entry) {
    return {timeEvidence(entry["time_s"].number(), {entry["x_m"].number(), entry["y_m"].number()}, entry["radius_m"].number(),
                         entry["accuracy_s"].number()),
            entry["used"].flag()};
}

}  // namespace

bool KeptCauses::empty() const {
    return causes.empty() && files.empty() && times.empty() && leftOutScenarios.empty() && leftOutEvidence.empty() && !blind;
}

KeptCauses readKeptCauses(const std::string& file) {
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(file, failed))) {
        return {};
    }
    const nlohmann::json document = readJsonDocument(file, causesKind);
    const JsonCursor top(document, file);
    const fs::path folder = folderOf(file);
    KeptCauses kept;
    for (const JsonCursor& entry : top["causes"].elements()) {
        kept.causes.push_back({pathFrom(folder, entry), entry["used"].flag()});
    }
    for (const JsonCursor& entry : top["files"].elements()) {
        kept.files.push_back({{fileKindFrom(entry["holds"]), pathFrom(folder, entry)}, entry["used"].flag()});
    }
    for (const JsonCursor& entry : top["times"].elements()) {
        kept.times.push_back(timeFrom(entry));
    }
    kept.leftOutScenarios = idsFrom(top["left_out_scenarios"]);
    kept.leftOutEvidence = idsFrom(top["left_out_evidence"]);
    kept.blind = top["blind"].flag();
    return kept;
}

void writeKeptCauses(const std::string& file, const KeptCauses& kept) {
    std::error_code failed;
    if (kept.empty()) {
        fs::remove(file, failed);
        return;
    }
    const fs::path folder = folderOf(file);
    nlohmann::json document = {{"format", causesKind.format},
                               {"version", causesKind.version},
                               {"causes", nlohmann::json::array()},
                               {"files", nlohmann::json::array()},
                               {"times", nlohmann::json::array()},
                               {"left_out_scenarios", kept.leftOutScenarios},
                               {"left_out_evidence", kept.leftOutEvidence},
                               {"blind", kept.blind}};
    for (const KeptCauses::Cause& cause : kept.causes) {
        document["causes"].push_back({{"path", pathBeside(folder, cause.path)}, {"used", cause.used}});
    }
    for (const KeptCauses::File& each : kept.files) {
        document["files"].push_back({{"holds", std::string(evidenceKeyword(each.file.kind))},
                                     {"path", pathBeside(folder, each.file.path)},
                                     {"used", each.used}});
    }
    for (const KeptCauses::Time& time : kept.times) {
        document["times"].push_back(timeJson(time));
    }
    fs::create_directories(folder, failed);
    // Whatever is wrong with the folder is told by the writing.
    writeAtomically(file, [&](std::ostream& out) { out << jsonText(document) << '\n'; });
}

}  // namespace rubble::io
