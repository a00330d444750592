#include "io/fe_reader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe_format.h"
#include "io/result_frame.h"
#include "io/series_digest.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// A result that was found: its format and its files.
struct Found {
    const FeFormat* format = nullptr;
    std::vector<std::string> files;
    std::vector<std::string> others;  ///< further results in the folder, by their first file
};

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

// By its own content, else as a member of a series whose first file is recognised.
Found findAt(const std::string& path, const FileHead& head) {
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

// What a user may have given instead, said in words.
std::string kindOf(const FileHead& head) {
    if (const ForeignFormat* foreign = foreignOf(head)) {
        return std::string(foreign->name);
    }
    bool text = true;
    const std::string bytes = head.bytes.substr(0, 64);
    for (const char c : bytes) {
        text &= static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t';
    }
    if (!text) {
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

[[noreturn]] void failUnknown(const FileHead& head) {
    Message remedy{"fe.unknown_format.remedy", "Formats that can be read: {0}.", {knownFormats()}};
    if (const ForeignFormat* foreign = foreignOf(head)) {
        remedy = {"fe.out_of_scope.remedy", "{0}", {std::string(foreign->remedy)}};
    }
    throw ParseError({"fe.unknown_format", "{0} is no FE result that can be read: it is {1}", {head.path, kindOf(head)}}, remedy);
}

// All results of a folder, each by its first file, in the order of the table and of the names.
std::vector<Found> resultsIn(const std::string& folder) {
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
    std::vector<Found> results;
    std::vector<std::string> seen;
    for (const std::string& path : paths) {
        if (std::binary_search(seen.begin(), seen.end(), path)) {
            continue;
        }
        const FeFormat* format = formatOf(readHead(path));
        if (!format) {
            continue;
        }
        Found found{format, format->members(path), {}};
        seen.insert(seen.end(), found.files.begin(), found.files.end());
        std::sort(seen.begin(), seen.end());
        const auto known = std::find_if(results.begin(), results.end(),
                                        [&](const Found& other) { return other.files.front() == found.files.front(); });
        if (known == results.end()) {
            results.push_back(std::move(found));
        }
    }
    std::stable_sort(results.begin(), results.end(), [](const Found& a, const Found& b) { return a.format < b.format; });
    return results;
}

Found findIn(const std::string& folder) {
    std::vector<Found> results = resultsIn(folder);
    if (results.empty()) {
        throw WorldError({"fe.folder", "{0} is a folder without an FE result", {folder}},
                         {"fe.folder.remedy", "Give the result file. Formats that can be read: {0}.", {knownFormats()}});
    }
    Found found = results.front();
    std::vector<std::string> same;
    for (const Found& other : results) {
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

Found find(const std::string& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return findIn(path);
    }
    const FileHead head = readHead(path);
    if (head.bytes.empty()) {
        throw ParseError({"fe.empty", "{0} is empty", {path}},
                         {"fe.empty.remedy", "Wait until the analysis has written it, or copy it again.", {}});
    }
    Found found = findAt(path, head);
    if (!found.format) {
        failUnknown(head);
    }
    return found;
}

std::uint64_t sizeOf(const std::vector<std::string>& files) {
    std::uint64_t bytes = 0;
    for (const std::string& file : files) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(file, error);
        bytes += error ? 0 : size;
    }
    return bytes;
}

// Of the frame that was decided on, so that a result is known again once the decision is recorded.
Digest fingerprintOf(const FeFormat& format, const std::string& sha256, const ImportSettings& settings,
                     const FeResult::Contents& contents) {
    const Frame& frame = contents.frame;
    Hasher hasher;
    hasher.text(format.name).value(format.version).text(sha256);
    hasher.text(settings.statusVariable).value(settings.activeValue.value_or(-1)).text(settings.displacement);
    for (const std::int64_t origin : frame.origin) {
        hasher.value(origin);
    }
    hasher.value(contents.units.metres).value(contents.units.kilograms).value(contents.units.seconds).text(frame.upAxis);
    return hasher.finish();
}

void requireTimes(const std::string& path, const std::vector<double>& times) {
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (!std::isfinite(times[k]) || (k > 0 && times[k] <= times[k - 1])) {
            throw ParseError(
                {"fe.times", "{0}: state {1} has the time {2}; times must be finite and grow", {path, k, {times[k], "s"}}},
                {"fe.times.remedy", "Remove the states that a restart wrote twice.", {}});
        }
    }
}

// Readers give what stands in the file; its units and axes are converted once for all.
FeResult::Contents readFound(const Found& found, const ImportSettings& settings, const Frame& frame, const Execution& execution) {
    const std::string& path = found.files.front();
    try {
        FeResult::Contents contents = found.format->read(path, settings, Frame{}, execution);
        requireTimes(path, contents.times);
        bringIntoFrame(contents, settings, frame, execution);
        // Tiny times may fall together in another unit.
        requireTimes(path, contents.times);
        return contents;
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    throw ParseError({"fe.memory", "{0} asks for more memory than there is", {path}},
                     {"fe.memory.remedy", "The file is damaged, or too large for this machine.", {}});
}

}  // namespace

std::shared_ptr<const FeResult> openFe(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                       const Execution& execution) {
    const Found found = find(path);
    const auto begun = std::chrono::steady_clock::now();
    FeResult::Contents contents = readFound(found, settings, frame, execution);
    contents.indexSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    contents.format = found.format->name;
    contents.path = found.files.front();
    contents.files = found.files;
    contents.bytes = sizeOf(found.files);
    contents.sha256 = sha256OfSeries(found.files, execution);
    contents.fingerprint = fingerprintOf(*found.format, contents.sha256, settings, contents);
    for (const std::string& other : found.others) {
        contents.findings.add({"fe.folder_others", "The folder holds further results, which were not read", {}},
                              {"fe.folder_others.remedy", "Give the file of the one that you want.", {}}, other);
    }
    return std::make_shared<const FeResult>(std::move(contents));
}

std::vector<std::string> feFiles(const std::string& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return findIn(path).files;
    }
    Found found = findAt(path, readHead(path));
    return found.format ? found.files : std::vector<std::string>{path};
}

bool hasGrown(const FeResult& fe) {
    std::error_code error;
    if (!fs::exists(fe.contents().path, error)) {
        return false;
    }
    const std::vector<std::string> files = feFiles(fe.contents().path);
    return files != fe.contents().files || sizeOf(files) != fe.contents().bytes;
}

std::string sha256OfFe(const std::string& path) {
    return sha256OfSeries(feFiles(path), Execution{});
}

}  // namespace rubble::io
