#include "io/exports/page/page_export.h"

#include <cctype>
#include <filesystem>

#include "core/base/build.h"
#include "io/base/base64.h"
#include "io/base/files.h"
#include "io/exports/page/page_facts.h"
#include "io/exports/page/page_scene.h"
#include "io/exports/page/page_site.h"
#include "io/exports/page/page_sources.h"
#include "io/exports/provenance.h"

namespace rubble::io {

namespace {

using nlohmann::json;

/// JSON inside a script element: nothing may end that early, and no comment may begin.
std::string embedded(std::string text) {
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
        text.replace(at, 1, "\\u003c");
    }
    return text;
}

std::string embedded(const json& value) {
    return embedded(value.dump(-1, ' ', true, json::error_handler_t::replace));
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// What a policy of content names a script or a style by: browsers then run nothing else.
std::string policyHash(std::string_view text) {
    const std::string hex = sha256OfText(text);
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    }
    return "'sha256-" + encodeBase64(bytes) + "'";
}

std::string_view kindName(PagePictureKind kind) {
    return kind == PagePictureKind::Map ? "map" : kind == PagePictureKind::Ground ? "ground" : "photograph";
}

std::string sourceOf(const PagePicture& picture) {
    return "data:" + picture.type + ";base64," + encodeBase64(picture.bytes);
}

/// Pictures that the script shows; those of the views are in the page itself, for readers without scripts.
json pictureList(const PageExtras& extras) {
    json list = json::array();
    for (const PagePicture& picture : extras.pictures) {
        if (picture.kind == PagePictureKind::Views) {
            continue;
        }
        json entry = {{"kind", kindName(picture.kind)}, {"name", picture.name}, {"source", sourceOf(picture)}};
        const auto text = [&extras](const Message& message) -> json {
            const std::string english = englishText(message);
            return {{"en", english}, {"zh", extras.chinese ? extras.chinese(message) : english}};
        };
        if (!picture.note.empty()) {
            entry["note"] = text(picture.note);
        }
        for (const Message& caution : picture.cautions) {
            entry["cautions"].push_back(text(caution));
        }
        list.push_back(std::move(entry));
    }
    return list;
}

std::string stills(const PageExtras& extras) {
    std::string figures;
    for (const PagePicture& picture : extras.pictures) {
        if (picture.kind == PagePictureKind::Views) {
            const std::string time = englishNumber(picture.time);
            figures += "<figure data-time=\"" + json(picture.time).dump() +
                       "\" tabindex=\"-1\"><img alt=\"FE result and fragments, t = " + time +
                       " s\" data-alt=\"stillAlt\" data-values='[\"" + time + "\"]' src=\"" + sourceOf(picture) +
                       "\"><figcaption>t = " + time + " s</figcaption></figure>\n";
        }
    }
    return figures;
}

/// What must be known beside the pictures, for readers without scripts, in both languages; a script puts its own in their place.
std::string warnings(const json& cautions) {
    std::string lines;
    const auto add = [&lines](std::string words, std::string_view stop, std::string_view attribute) {
        words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
        lines += "<p role=\"note\"" + std::string(attribute) + ">" + escaped(words) + std::string(stop) + "</p>\n";
    };
    for (const json& caution : cautions) {
        const auto english = caution["what"]["en"].get<std::string>();
        const auto chinese = caution["what"]["zh"].get<std::string>();
        add(english, ".", "");
        if (chinese != english) {
            add(chinese, "。", " lang=\"zh-CN\"");
        }
    }
    return lines;
}

/// What stands at the places of the frame.
struct PageParts {
    std::string title;
    std::string policy;
    std::string facts;
    std::string data;
    std::string warnings;
    std::string stills;
    std::string pictures;
    std::string provenance;
};

void writeFrame(std::ostream& out, const PageParts& parts) {
    const std::pair<std::string_view, std::string_view> places[] = {
        {"title", parts.title},   {"policy", parts.policy},     {"style", pageStyle()},
        {"facts", parts.facts},   {"data", parts.data},         {"warnings", parts.warnings},
        {"stills", parts.stills}, {"pictures", parts.pictures}, {"provenance", parts.provenance},
        {"script", pageScript()}, {"opening", pageOpening()}};
    std::string_view rest = pageFrame();
    while (!rest.empty()) {
        const std::size_t open = rest.find("{{");
        if (open == std::string_view::npos) {
            break;
        }
        const std::size_t close = rest.find("}}", open);
        const std::string_view name = rest.substr(open + 2, close - open - 2);
        out << rest.substr(0, open);
        for (const auto& [known, text] : places) {
            if (known == name) {
                out << text;
            }
        }
        rest.remove_prefix(close + 2);
    }
    out << rest;
}

}  // namespace

PageReport exportPage(const std::string& path, const RunReader& run, const FeResult& fe, const PageExtras& extras,
                      const Execution& execution) {
    const Message stage{"io.export.page", "Writing {0}", {path}};
    execution.report(stage, 0.0);
    PageScene scene = pageScene(run, fe, {}, execution);
    addSite(scene, extras.surroundings.get());
    json facts = pageFacts(run, fe, extras, scene);
    scene.about["arrays"] = scene.data.contents();
    scene.about["dataBytes"] = scene.data.size();
    facts["scene"] = scene.about;
    PageParts parts;
    parts.title = escaped(facts["title"].get<std::string>());
    parts.policy = "default-src 'none'; script-src " + policyHash(pageOpening()) + " " + policyHash(pageScript()) + "; style-src " +
                   policyHash(pageStyle()) + "; img-src data:; form-action 'none'; base-uri 'none'";
    parts.facts = embedded(facts);
    parts.warnings = warnings(facts["cautions"]);
    parts.stills = stills(extras);
    parts.pictures = embedded(pictureList(extras));
    const double end = run.frameTime(run.frameCount() - 1);
    const ExportRecord record{"page",
                              {{"Conventional FE result", fe.times().front(), fe.times().back(), "FE"},
                               {"Fragments", fe.times().front(), end, std::string(shownClass(FrameKind::Interpolated))}},
                              {},
                              {},
                              extras.casePath,
                              extras.around};
    parts.provenance = embedded(exportProvenance(record, run.origin(), &run));
    parts.data = encodeBase64(scene.data.compressed(execution));
    writeAtomically(path, [&](std::ostream& out) { writeFrame(out, parts); });
    execution.report(stage, 1.0);
    return {std::filesystem::file_size(path),     scene.placeError, scene.nodeError,     scene.nodeErrorBetween,
            scene.statesThere - scene.statesKept, scene.siteError,  scene.siteTriangles, scene.siteLeftOut};
}

}  // namespace rubble::io
