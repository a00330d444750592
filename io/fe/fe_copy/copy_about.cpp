#include "io/fe/fe_copy/copy_about.h"

#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "io/json/findings_json.h"
#include "io/json/scenario_json.h"

namespace rubble::io {

using nlohmann::json;

namespace {

FileUnits unitsFrom(const JsonCursor& list) {
    const std::vector<JsonCursor> values = list.elements();
    if (values.size() != 3) {
        list.fail("metres, kilograms and seconds");
    }
    const FileUnits units{values[0].number(), values[1].number(), values[2].number()};
    if (!(units.metres > 0.0 && units.kilograms >= 0.0 && units.seconds > 0.0)) {
        list.fail("units above zero");
    }
    return units;
}

}  // namespace

std::string aboutText(const FeResult& fe) {
    const FeResult::Contents& contents = fe.contents();
    json parts = json::array();
    for (const Part& part : fe.mesh().parts) {
        parts.push_back({{"name", part.name}, {"id", part.fileId}});
    }
    const json about{{"format", contents.format},
                     {"path", contents.path},
                     {"files", contents.files},
                     {"bytes", contents.bytes},
                     {"sha256", contents.sha256},
                     {"activity_from", contents.activityFrom},
                     {"build", buildText()},
                     {"has_velocity", contents.hasVelocity},
                     {"units", {contents.units.metres, contents.units.kilograms, contents.units.seconds}},
                     {"frame", frameJson(contents.frame)},
                     {"units_from", contents.unitsFrom},
                     {"parts", parts},
                     {"findings", findingsJson(contents.findings)}};
    // Names of files may hold bytes that are not UTF-8.
    return about.dump(1, ' ', false, json::error_handler_t::replace);
}

CopyAbout aboutFromText(const std::string& text, const std::string& path) {
    const json document = parseJson(text, path);
    const JsonCursor cursor(document, path);
    CopyAbout about;
    about.format = cursor["format"].text();
    about.path = cursor["path"].text();
    for (const JsonCursor& file : cursor["files"].elements()) {
        about.files.push_back(file.text());
    }
    about.bytes = static_cast<std::uint64_t>(cursor["bytes"].integer());
    about.sha256 = cursor["sha256"].text();
    about.activityFrom = cursor["activity_from"].text();
    about.build = cursor["build"].text();
    about.hasVelocity = cursor["has_velocity"].flag();
    about.units = unitsFrom(cursor["units"]);
    about.frame = frameFromJson(cursor["frame"]);
    about.unitsFrom = cursor["units_from"].text();
    for (const JsonCursor& part : cursor["parts"].elements()) {
        about.parts.push_back({part["name"].text(), part["id"].integer()});
    }
    about.findings = findingsFromJson(cursor["findings"]);
    return about;
}

}  // namespace rubble::io
