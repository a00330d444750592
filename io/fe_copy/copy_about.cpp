#include "io/fe_copy/copy_about.h"

#include "core/base/build.h"
#include "io/findings_json.h"

namespace rubble::io {

using nlohmann::json;

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
    for (const JsonCursor& part : cursor["parts"].elements()) {
        about.parts.push_back({part["name"].text(), part["id"].integer()});
    }
    about.findings = findingsFromJson(cursor["findings"]);
    return about;
}

}  // namespace rubble::io
