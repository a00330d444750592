#include "io/fe/radioss/anim_reader.h"

#include <algorithm>
#include <filesystem>

#include "io/fe/radioss/converted_file.h"
#include "io/fe/radioss/radioss_run.h"
#include "io/fe/series/part_membership.h"

namespace rubble::io {

namespace {

constexpr const char* afterNumber = ".vtk";

// The deck of run NAME is NAME_0000.rad, beside its results.
std::string deckOf(const std::string& path, const std::string& marks, const std::string& ending) {
    const std::filesystem::path file(path);
    std::string name = file.filename().string();
    name.resize(name.size() - (name.ends_with(".gz") ? 3 : 0));
    name.resize(name.size() - (name.ends_with(ending) ? ending.size() : 0));
    name.resize(name.find_last_not_of("0123456789") + 1);
    if (!name.empty() && marks.find(name.back()) != std::string::npos) {
        name.pop_back();
    }
    return (file.parent_path() / (name + "_0000.rad")).string();
}

// The deck belongs to the files: what it says goes into the result.
std::vector<std::string> withDeck(std::vector<std::string> files, const std::string& deck) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(deck, ignored)) {
        files.push_back(deck);
    }
    return files;
}

std::vector<std::string> animStates(const std::string& path) {
    return numberedMembers(path, "A", "");
}

std::vector<std::string> convertedStates(const std::string& path) {
    return numberedMembers(path, "", afterNumber);
}

}  // namespace

// Versions before 2017 begin with smaller numbers; they are known and refused by name.
bool recognisesAnim(const FileHead& head) {
    constexpr unsigned char oldest = 0x26, newest = 0x2C;
    return head.bytes.size() >= 8 && head.bytes[0] == 0 && head.bytes[1] == 0 && head.bytes[2] == 0x54 &&
           static_cast<unsigned char>(head.bytes[3]) >= oldest && static_cast<unsigned char>(head.bytes[3]) <= newest;
}

std::vector<std::string> animMembers(const std::string& path) {
    return withDeck(animStates(path), deckOf(path, "A", ""));
}

std::vector<std::string> animFilesAlone(const std::string& path) {
    return withDeck({path}, deckOf(path, "A", ""));
}

FeResult::Contents readAnim(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    FeResult::Contents contents = readRadiossRun({settings.onlyThisFile ? std::vector<std::string>{path} : animStates(path),
                                                  readAnimFile, deckOf(path, "A", ""), "status byte, 0 is deleted"},
                                                 execution);
    killParts(settings.deadParts, *contents.mesh, contents.activity, contents.activityFrom, path);
    return contents;
}

bool recognisesConvertedAnim(const FileHead& head) {
    const auto has = [&](const char* text) { return head.bytes.find(text) != std::string::npos; };
    return head.bytes.starts_with("# vtk DataFile Version") && has("\nASCII") && has("\nDATASET UNSTRUCTURED_GRID") &&
           has("\nTIME 1 1 double") && has("\nCYCLE 1 1 int");
}

std::vector<std::string> convertedAnimMembers(const std::string& path) {
    return withDeck(convertedStates(path), deckOf(path, "A_", afterNumber));
}

std::vector<std::string> convertedAnimFilesAlone(const std::string& path) {
    return withDeck({path}, deckOf(path, "A_", afterNumber));
}

FeResult::Contents readConvertedAnim(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    FeResult::Contents contents =
        readRadiossRun({settings.onlyThisFile ? std::vector<std::string>{path} : convertedStates(path), readConvertedFile,
                        deckOf(path, "A_", afterNumber), "EROSION_STATUS, 1 is active"},
                       execution);
    std::int64_t never = 0;
    std::string example;
    for (std::size_t e = 0; e < contents.mesh->elementCount(); ++e) {
        bool any = false;
        for (std::size_t k = 0; k < contents.times.size() && !any; ++k) {
            any = contents.activity.active(k, idAt<ElementIndex>(e));
        }
        if (!any && never++ == 0) {
            example = "element " + std::to_string(contents.mesh->elementIds[e]);
        }
    }
    if (never > 0) {
        contents.findings.add(
            {"anim.never_active", "Elements are inactive in every state: they may be rigid, which these files do not tell", {}},
            {"anim.never_active.remedy", "Give the animation files (A001, ...) that they were made from.", {}}, example, never);
    }
    killParts(settings.deadParts, *contents.mesh, contents.activity, contents.activityFrom, path);
    return contents;
}

}  // namespace rubble::io
