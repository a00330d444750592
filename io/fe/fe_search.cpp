#include "io/fe/fe_search.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t textHead = 64;  // bytes that tell a text

const ForeignFormat* foreignOf(const FileHead& head) {
    for (const ForeignFormat& foreign : foreignFormats()) {
        if (foreign.recognises(head)) {
            return &foreign;
        }
    }
    return nullptr;
}

// What is out of scope comes first: Exodus II would take any file of HDF5.
const FeFormat* formatOf(const FileHead& head) {
    if (foreignOf(head)) {
        return nullptr;
    }
    for (const FeFormat& format : feFormats()) {
        if (format.recognises(head)) {
            return &format;
        }
    }
    return nullptr;
}

bool isText(const FileHead& head) {
    const std::string bytes = head.bytes.substr(0, textHead);
    return std::all_of(bytes.begin(), bytes.end(),
                       [](char c) { return static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t'; });
}

// What a user may have given instead, said in words.
std::string kindOf(const FileHead& head) {
    if (const ForeignFormat* foreign = foreignOf(head)) {
        return std::string(foreign->name);
    }
    const std::string bytes = head.bytes.substr(0, textHead);
    if (!isText(head)) {
        return "a binary file of another format";
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && bytes[first] == '{') {
        return "a JSON text, perhaps a case";
    }
    if (bytes.starts_with("# vtk DataFile")) {
        return "a VTK legacy file";
    }
    if (bytes.starts_with("<?xml") || bytes.starts_with("<VTKFile")) {
        return "an XML text";
    }
    return "a text";
}

std::string knownFormats() {
    std::string list;
    for (const FeFormat& format : feFormats()) {
        list += (list.empty() ? "" : "; ") + std::string(format.name) + " (" + std::string(format.endings) + ")";
    }
    return list;
}

// d3plot of d3plot07: the states of a family do not say what they are. Empty: the name has no number.
std::string rootOfFamily(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    const std::size_t last = name.find_last_not_of("0123456789");
    return last == std::string::npos || name.size() - last < 3 ? "" : name.substr(0, last + 1);
}

[[noreturn]] void failUnknown(const FileHead& head) {
    Message remedy{"fe.unknown_format.remedy", "Formats that can be read: {0}.", {knownFormats()}};
    if (const std::string root = rootOfFamily(head.path); !root.empty() && !isText(head) && !foreignOf(head)) {
        remedy = {"fe.unknown_format.family",
                  "If it holds states of a d3plot family, put the first file of the family, {0}, beside it. Formats that can be "
                  "read: {1}.",
                  {root, knownFormats()}};
    }
    if (const ForeignFormat* foreign = foreignOf(head)) {
        remedy = {"fe.out_of_scope.remedy", "{0}", {std::string(foreign->remedy)}};
    }
    throw ParseError({"fe.unknown_format", "{0} is no FE result that can be read: it is {1}", {head.path, kindOf(head)}}, remedy);
}

// All results of a folder, each by its first file, in the order of the table and of the names.
std::vector<FoundFe> resultsIn(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) {
            paths.push_back(entry->path().string());
        }
    }
    if (error) {
        throw WorldError({"fe.folder_unreadable", "The folder {0} cannot be read: {1}", {folder, error.message()}},
                         {"fe.unreadable.remedy", "Check the path and that you may read the file.", {}});
    }
    std::sort(paths.begin(), paths.end());
    std::vector<FoundFe> results;
    std::vector<std::string> seen;
    for (const std::string& path : paths) {
        if (std::binary_search(seen.begin(), seen.end(), path)) {
            continue;
        }
        const FeFormat* format = formatOf(readHead(path));
        if (!format) {
            continue;
        }
        FoundFe found{format, format->members(path), {}};
        seen.insert(seen.end(), found.files.begin(), found.files.end());
        std::sort(seen.begin(), seen.end());
        const auto known = std::find_if(results.begin(), results.end(),
                                        [&](const FoundFe& other) { return other.files.front() == found.files.front(); });
        if (known == results.end()) {
            results.push_back(std::move(found));
        }
    }
    std::stable_sort(results.begin(), results.end(), [](const FoundFe& a, const FoundFe& b) { return a.format < b.format; });
    return results;
}

FoundFe findIn(const std::string& folder) {
    std::vector<FoundFe> results = resultsIn(folder);
    if (results.empty()) {
        throw WorldError({"fe.folder", "{0} is a folder without an FE result", {folder}},
                         {"fe.folder.remedy", "Give the result file. Formats that can be read: {0}.", {knownFormats()}});
    }
    FoundFe found = results.front();
    std::vector<std::string> same;
    for (const FoundFe& other : results) {
        const std::string name = fs::path(other.files.front()).filename().string();
        if (other.format == found.format) {
            same.push_back(name);
        } else {
            found.others.push_back(name);
        }
    }
    if (same.size() > 1) {
        throw WorldError({"fe.folder_several", "The folder {0} holds {1} results of one format", {folder, same.size()}},
                         {"fe.folder_several.remedy", "Give one of them: {0}.", {quotedList(same, 100)}});
    }
    return found;
}

}  // namespace

FoundFe findFeAt(const std::string& path, const FileHead& head) {
    if (const FeFormat* format = formatOf(head)) {
        return {format, format->members(path), {}};
    }
    for (const FeFormat& format : feFormats()) {
        std::vector<std::string> files = format.members(path);
        if (files.front() != path && format.recognises(readHead(files.front()))) {
            return {&format, std::move(files), {}};
        }
    }
    return {};
}

FoundFe findFe(const std::string& path, bool alone) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return findIn(path);
    }
    const FileHead head = readHead(path);
    FoundFe found = findFeAt(path, head);
    if (!found.format && head.bytes.empty()) {
        throw ParseError({"fe.empty", "{0} is empty", {path}},
                         {"fe.empty.remedy", "Wait until the analysis has written it, or copy it again.", {}});
    }
    if (!found.format) {
        failUnknown(head);
    }
    return alone ? onlyFile(found, path) : found;
}

FoundFe onlyFile(FoundFe found, const std::string& path) {
    const std::string file = found.format->recognises(readHead(path)) ? path : found.files.front();
    found.files = found.format->alone != nullptr ? found.format->alone(file) : found.format->members(file);
    return found;
}

void notePiece(const FoundFe& found, const std::string& path, Findings& findings) {
    std::error_code ignored;
    const bool given = !fs::is_directory(path, ignored) && found.files.size() > 1 && found.format->holdsPiece != nullptr &&
                       found.format->holdsPiece(path);
    if (given) {
        findings.add({"fe.piece", "The file holds a piece of each state: the whole result was opened", {}},
                     {"fe.piece.remedy", "Nothing to do; only_this_file=true opens the piece by itself.", {}},
                     fs::path(path).filename().string() + ", one of " +
                         englishInteger(static_cast<std::int64_t>(found.files.size())) + " files");
    }
}

Digest feFingerprint(const FeFormat& format, const std::string& sha256, const ImportSettings& settings, const Frame& frame,
                     const FileUnits& units) {
    Hasher hasher;
    hasher.text(format.name).value(format.version).text(sha256);
    if (settings.onlyThisFile) {
        hasher.text("only_this_file");
    }
    hasher.text(settings.statusVariable).value(settings.activeValue.value_or(-1)).text(settings.displacement);
    if (!settings.deadParts.empty()) {
        hasher.text(settings.deadParts);
    }
    for (const std::int64_t origin : frame.origin) {
        hasher.value(origin);
    }
    hasher.value(units.metres).value(units.kilograms).value(units.seconds).text(frame.upAxis);
    return hasher.finish();
}

}  // namespace rubble::io
