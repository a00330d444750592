#include "io/exports/provenance.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "core/base/error.h"
#include "io/base/embedded_text.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/exports.h"
#include "io/fe/fe_reader.h"
#include "io/json/json_cursor.h"
#include "io/json/registration_json.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_json.h"

namespace rubble::io {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// In XML and comments of a movie the text stands as it is: nothing may end a section of it early.
std::string asciiLine(const json& value) {
    std::string line = value.dump(-1, ' ', true, json::error_handler_t::replace);
    for (std::size_t at = line.find("]]>"); at != std::string::npos; at = line.find("]]>", at)) {
        line.replace(at, 3, "]]\\u003e");
    }
    return line;
}

json objectOf(const std::string& text) {
    return text.empty() ? json(nullptr) : json::parse(text);
}

std::string absolutePath(const std::string& path) {
    return path.empty() ? path : fs::absolute(path).lexically_normal().string();
}

std::string textAt(const json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool sameFe(const std::string& path, const std::string& sha256) {
    try {
        return sha256OfFe(path) == sha256;
    } catch (const Error&) {
        return false;
    }
}

/// The case if its FE input is the one of the export; nothing otherwise.
std::optional<ExportSource> asCase(const std::string& path, const ReadProvenance& provenance) {
    std::error_code ignored;
    if (path.empty() || !fs::is_regular_file(path, ignored) || !isCaseFile(path)) {
        return std::nullopt;
    }
    try {
        const Case theCase = loadCase(path);
        const bool same = std::any_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) {
            return input.role == InputRole::Fe && input.sha256 == provenance.feSha256;
        });
        if (!same) {
            return std::nullopt;
        }
        ExportSource source{absolutePath(path), true, {}, {}};
        for (const CaseScenario& scenario : theCase.scenarios) {
            if (scenario.name == provenance.scenarioName) {
                source.scenarioId = scenario.id;
            }
        }
        return source;
    } catch (const Error&) {
        // A case that cannot be read is not the one looked for.
        return std::nullopt;
    }
}

/// Where the case may be, the nearest first: as recorded, beside the export, above it, beside the FE result, and what is known.
std::vector<std::string> candidates(const ReadProvenance& provenance, const std::string& exportPath,
                                    std::span<const std::string> known) {
    const fs::path folder = fs::absolute(exportPath).parent_path();
    std::vector<std::string> paths;
    if (!provenance.casePath.empty()) {
        paths.push_back(provenance.casePath);
        paths.push_back((folder / fs::path(provenance.casePath).filename()).string());
    }
    for (const fs::path& where : {folder, folder.parent_path(), fs::path(provenance.fePath).parent_path()}) {
        std::vector<std::string> there;
        std::error_code failed;
        for (fs::directory_iterator it(where, failed), end; !failed && it != end; it.increment(failed)) {
            if (it->path().extension() == ".rubble") {
                there.push_back(it->path().string());
            }
        }
        std::sort(there.begin(), there.end());
        paths.insert(paths.end(), there.begin(), there.end());
    }
    paths.insert(paths.end(), known.begin(), known.end());
    return paths;
}

/// The run file if it still is that run; empty otherwise.
std::string sameRun(const ReadProvenance& provenance, const std::string& exportPath) {
    if (provenance.runPath.empty() || provenance.fingerprint.empty()) {
        return {};
    }
    const fs::path beside = fs::absolute(exportPath).parent_path() / fs::path(provenance.runPath).filename();
    for (const std::string& path : {provenance.runPath, beside.string()}) {
        try {
            if (fs::exists(path) && openRun(path)->origin().fingerprint.hex() == provenance.fingerprint) {
                return path;
            }
        } catch (const std::exception&) {
            // Another file lies there now.
        }
    }
    return {};
}

}  // namespace

namespace {

json cloudJson(const ShownCloud& cloud) {
    json object{{"path", cloud.file.path},
                {"sha256", cloud.file.sha256},
                {"registration", cloud.placed ? registrationJson(*cloud.placed) : json(nullptr)},
                {"points_shown", cloud.shown},
                {"points", cloud.all},
                {"far_points_not_drawn", cloud.far},
                {"levels_left_out", !cloud.whole},
                {"colours", cloud.colours}};
    if (cloud.finest) {
        object["finest_cells_m"] = jsonNumber(*cloud.finest);
    }
    if (cloud.detection) {
        object["level_of_detection_m"] = jsonNumber(*cloud.detection);
        object["registration_in_level_of_detection"] = cloud.registrationInDetection;
    }
    return object;
}

}  // namespace

std::string_view shownClass(FrameKind kind) {
    switch (kind) {
        case FrameKind::Fe:
            return "FE";
        case FrameKind::Simulated:
            return "simulated";
        case FrameKind::Interpolated:
            return "simulated, interpolated between two recorded instants";
        case FrameKind::Illustrative:
            break;
    }
    return "illustrative";
}

std::string footLine(const RunOrigin& origin, bool simulated) {
    constexpr std::size_t figures = 16;  // tell one digest from another
    const std::string run = simulated ? ", run " + origin.fingerprint.hex().substr(0, figures) : std::string();
    const std::string terrain =
        origin.terrainSha256.empty() ? std::string() : ", terrain " + origin.terrainSha256.substr(0, figures);
    return "FE " + origin.feSha256.substr(0, figures) + terrain + run + ", " + std::string(shortBuild(origin.build));
}

std::vector<ShownFile> shownFiles(const TerrainInput& around) {
    std::vector<ShownFile> files;
    for (const SiteFile& file : around.files) {
        files.push_back(
            {file.input == around.orthophotoInput ? "orthophoto" : "surroundings", absolutePath(file.path), file.sha256});
    }
    return files;
}

ShownFile shownCloudFile(const std::string& path, const CloudStamp& then, const Execution& execution) {
    const auto check = [&] {
        if (stampOf(path) != then) {
            throw WorldError({"io.provenance.cloud_changed", "{0} changed after its points were read", {path}},
                             {"io.provenance.cloud_changed.remedy", "Show its points anew, and export then.", {}});
        }
    };
    check();
    const auto bytes = static_cast<double>(std::max<std::uint64_t>(1, then.bytes));
    double done = 0.0;
    std::string sha256 = sha256OfFile(path, [&](std::size_t block) {
        done += static_cast<double>(block);
        execution.report({"octree.digest", "Reading the cloud for its digest", {}}, std::min(1.0, done / bytes));
    });
    check();
    return {"cloud", absolutePath(path), std::move(sha256)};
}

std::string exportProvenance(const ExportRecord& record, const RunOrigin& origin, const RunReader* run) {
    json about = json::parse(provenanceText(origin, run));
    about["kind"] = record.kind;
    about["case_path"] = absolutePath(record.casePath);
    about["run_path"] = run != nullptr && run->kept() ? absolutePath(run->path()) : std::string();
    about["simulated"] = run != nullptr;
    about["shown"] = json::array();
    for (const ShownPart& part : record.shown) {
        json entry = {{"name", part.name}, {"class", part.shownAs}, {"time_s", part.time}};
        if (part.until) {
            entry["until_s"] = *part.until;
        }
        about["shown"].push_back(std::move(entry));
    }
    for (const ShownFile& file : record.around) {
        json input = {{"role", file.role}, {"path", file.path}, {"sha256", file.sha256}};
        // Meshes that debris fell on are among the inputs of the run already.
        if (std::find(about["inputs"].begin(), about["inputs"].end(), input) == about["inputs"].end()) {
            about["inputs"].push_back(std::move(input));
        }
    }
    about["clouds"] = json::array();
    for (const ShownCloud& cloud : record.clouds) {
        about["inputs"].push_back({{"role", cloud.file.role}, {"path", cloud.file.path}, {"sha256", cloud.file.sha256}});
        about["clouds"].push_back(cloudJson(cloud));
    }
    about["settings_of_export"] = objectOf(record.settings);
    about["view"] = objectOf(record.view);
    // The mark stands first, whatever the order of the keys.
    return std::string(provenanceStart) + "1," + asciiLine(about).substr(1);
}

std::optional<ReadProvenance> readProvenance(const std::string& path) {
    std::string text = embeddedProvenance(path);
    std::error_code ignored;
    if (const std::string sidecar = path + ".provenance.json"; text.empty() && fs::is_regular_file(sidecar, ignored)) {
        text = embeddedProvenance(sidecar);
    }
    if (text.empty()) {
        return std::nullopt;
    }
    const json about = parseJson(text, path);
    ReadProvenance read;
    read.text = text;
    read.kind = textAt(about, "kind");
    read.casePath = textAt(about, "case_path");
    read.runPath = textAt(about, "run_path");
    read.scenarioName = textAt(about, "scenario_name");
    if (about.value("simulated", false)) {
        read.fingerprint = textAt(about, "fingerprint");
    }
    if (const auto view = about.find("view"); view != about.end() && view->is_object()) {
        read.view = view->dump();
    }
    if (const auto settings = about.find("settings_of_export"); settings != about.end() && settings->is_object()) {
        const json panel = settings->value("panel_pixels", json::array());
        const bool told = panel.is_array() && panel.size() == 2 && panel[0].is_number() && panel[1].is_number();
        const double height = told ? panel[1].get<double>() : 0.0;
        read.aspect = height > 0.0 ? panel[0].get<double>() / height : 0.0;
    }
    if (const auto inputs = about.find("inputs"); inputs != about.end() && inputs->is_array()) {
        for (const json& input : *inputs) {
            if (textAt(input, "role") == "fe") {
                read.fePath = textAt(input, "path");
                read.feSha256 = textAt(input, "sha256");
            }
        }
    }
    if (read.feSha256.empty()) {
        throw ParseError({"io.provenance.damaged", "{0}: its provenance names no FE result", {path}},
                         {"io.provenance.damaged.remedy", "Take the file as it was exported, or export it again.", {}});
    }
    return read;
}

ExportSource findSource(const ReadProvenance& provenance, const std::string& exportPath, std::span<const std::string> known,
                        const Execution& execution) {
    std::optional<ExportSource> found;
    for (const std::string& path : candidates(provenance, exportPath, known)) {
        execution.check();
        const std::optional<ExportSource> one = asCase(path, provenance);
        // Of cases on the same FE result the one with the scenario is meant.
        if (one && (!found || !one->scenarioId.empty())) {
            found = one;
        }
        if (found && !found->scenarioId.empty()) {
            break;
        }
    }
    const fs::path beside = fs::absolute(exportPath).parent_path() / fs::path(provenance.fePath).filename();
    for (const std::string& path : {provenance.fePath, beside.string()}) {
        if (!found && sameFe(path, provenance.feSha256)) {
            found = ExportSource{path, false, {}, {}};
        }
    }
    if (!found) {
        throw WorldError({"io.provenance.no_source",
                          "The case of {0} was not found: neither {1} nor a case beside it stands on the FE result {2} with the "
                          "SHA-256 {3}.",
                          {exportPath, provenance.casePath.empty() ? std::string("a case") : provenance.casePath, provenance.fePath,
                           provenance.feSha256}},
                         {"io.provenance.no_source.remedy", "Put the figure beside its case, or open the case first.", {}});
    }
    found->runPath = sameRun(provenance, exportPath);
    return *found;
}

}  // namespace rubble::io
