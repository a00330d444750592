#include "io/case/case_photographs.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/site/clouds/e57/placed_photographs.h"
#include "io/site/photograph_file.h"

namespace rubble::io {

namespace fs = std::filesystem;

WrittenPictures::~WrittenPictures() {
    std::error_code ignored;
    for (const std::string& path : paths) {
        if (!kept && fs::remove(path, ignored)) {
            fs::remove(fs::path(path).parent_path(), ignored);  // once it is empty
        }
    }
}

namespace {

bool hasPhotograph(const Case& theCase, const std::string& sha256) {
    return std::any_of(theCase.inputs.begin(), theCase.inputs.end(),
                       [&](const CaseInput& input) { return input.role == InputRole::Photograph && input.sha256 == sha256; });
}

}  // namespace

std::optional<std::string> addPhotograph(Case& theCase, const std::string& casePath, const std::string& path,
                                         const PhotoFacts& facts, const std::string& sha256) {
    std::vector<CaseInput>& inputs = theCase.inputs;
    const auto any = [&](const auto& is) { return std::any_of(inputs.begin(), inputs.end(), is); };
    if (hasPhotograph(theCase, sha256)) {
        return std::nullopt;
    }
    int number = 1;
    std::string id = "photograph-1";
    while (any([&](const CaseInput& input) { return input.id == id; })) {
        id = "photograph-" + std::to_string(++number);
    }
    const fs::path folder = fs::absolute(casePath).parent_path().lexically_normal();
    const fs::path relative = fs::absolute(path).lexically_normal().lexically_proximate(folder);
    inputs.push_back({id, InputRole::Photograph, relative.generic_string(), sha256});
    Photograph& added = theCase.photographs.emplace_back();
    added.input = id;
    added.facts = facts;
    added.camera.width = facts.width;
    added.camera.height = facts.height;
    added.camera.freePrincipal = cropped(facts);
    return id;
}

AddedPhotographs addPhotographsOfCloud(Case& theCase, const std::string& casePath, const std::string& cloud, const Frame& frame,
                                       Findings& findings, const Execution& execution) {
    CaseInput stated;
    std::error_code ignored;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Survey && fs::equivalent(inputPath(casePath, input), cloud, ignored)) {
            stated = input;
        }
    }
    AddedPhotographs added;
    const fs::path beside = fs::absolute(casePath).parent_path() / (fs::path(cloud).filename().string() + "-photographs");
    const std::vector<PlacedPhotograph> pictures =
        placedPhotographs(cloud, stated.read, frame, theCase.site, stated.registration, findings, execution);
    Case grown = theCase;
    added.written = std::make_shared<WrittenPictures>();
    const Message adding{"cloud.photographs_adding", "Adding photographs of the cloud", {}};
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        execution.report(adding, static_cast<double>(k) / static_cast<double>(pictures.size()));
        const PlacedPhotograph& photograph = pictures[k];
        const std::string_view content(reinterpret_cast<const char*>(photograph.bytes.data()), photograph.bytes.size());
        if (hasPhotograph(grown, sha256OfText(content))) {
            ++added.known;  // wherever its file lies: a second one would be nobody's
            continue;
        }
        std::string path = (beside / photograph.name).string();
        if (const auto there = contentOf(path); there && *there != content) {
            // Of another cloud of this name, or changed since: another photograph of the case may be that one.
            path = (beside / (Hasher().text(content).finish().hex().substr(0, 8) + "-" + photograph.name)).string();
        }
        const bool written = contentOf(path) != content;
        if (written) {
            writeIn(path, content);
            added.written->paths.push_back(path);
        }
        PhotographFile file;
        try {
            file = readPhotograph(path);
        } catch (const ParseError& error) {
            // The others may be whole.
            findings.add(error.message(), error.remedy(), photograph.name);
            if (written) {
                fs::remove(path, ignored);
            }
            continue;
        }
        findings.append(file.findings);
        added.ids.push_back(*addPhotograph(grown, casePath, path, file.facts, file.sha256));
        Photograph& last = grown.photographs.back();
        if (file.facts.width != photograph.camera.width || file.facts.height != photograph.camera.height) {
            findings.add(
                {"cloud.photograph_size",
                 "{0} x {1} pixels, upright, where the cloud states the camera of {2} x {3}: the photograph is added without it",
                 {file.facts.width, file.facts.height, photograph.camera.width, photograph.camera.height}},
                {"cloud.photograph_size.remedy", "Match its camera by points in the window.", {}}, photograph.name);
            continue;
        }
        last.camera = photograph.camera;
        last.pairs = photograph.pairs;
        last.note = "camera as " + fs::path(cloud).filename().string() + " states it";
    }
    execution.report(adding, 1.0);
    theCase = std::move(grown);
    return added;
}

}  // namespace rubble::io
