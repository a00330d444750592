#include "io/fe/fe_reader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "core/base/error.h"
#include "io/fe/fe_copy/file_traces.h"
#include "io/fe/fe_search.h"
#include "io/fe/pieces/elements_twice.h"
#include "io/fe/result_frame.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series_digest.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

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
FeResult::Contents readFound(const FoundFe& found, const ImportSettings& settings, const Frame& frame, const Execution& execution) {
    const std::string& path = found.files.front();
    try {
        FeResult::Contents contents = found.format->read(path, settings, execution);
        requireTimes(path, contents.times);
        bringIntoFrame(contents, settings, frame, execution);
        if (const std::string list = deathListBeside(path);
            !list.empty() && contents.findings.count("fe.death_list.unused") == 0 && !contents.deathTime.empty()) {
            requireClockOfDeathList(list, contents.units);
        }
        // Tiny times may fall together in another unit.
        requireTimes(path, contents.times);
        return contents;
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    throw ParseError({"fe.memory", "{0} asks for more memory than there is", {path}},
                     {"fe.memory.remedy", "The file is damaged, or too large for this machine.", {}});
}

// Files whose names differ in a number, whose meshes differ and of which nobody says when they are, are no states of one analysis.
FeResult::Contents readOrAlone(FoundFe& found, const std::string& path, const ImportSettings& settings, const Frame& frame,
                               const Execution& execution) {
    try {
        return readFound(found, settings, frame, execution);
    } catch (const ParseError& error) {
        std::error_code ignored;
        if (error.message().id != "fe.other_points" || settings.onlyThisFile || fs::is_directory(path, ignored)) {
            throw;
        }
    }
    const std::vector<std::string> all = found.files;
    found = onlyFile(found, path);
    ImportSettings alone = settings;
    alone.onlyThisFile = true;
    FeResult::Contents contents = readFound(found, alone, frame, execution);
    contents.alone = true;
    contents.findings.add(
        {"fe.variants", "Files that differ in a number have other meshes and no times: they were not taken for states", {}},
        {"fe.variants.remedy", "Give a .pvd or .series file with the times if they are states of one analysis.", {}},
        takenForStates(all), static_cast<std::int64_t>(all.size()) - 1);
    return contents;
}

}  // namespace

std::shared_ptr<const FeResult> openFe(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                       const Execution& execution) {
    FoundFe found = findFe(path, settings.onlyThisFile);
    const auto begun = std::chrono::steady_clock::now();
    // What is written while this reads counts as growth.
    std::vector<FileTrace> traces = tracesOf(found.files);
    FeResult::Contents contents = readOrAlone(found, path, settings, frame, execution);
    if (traces.size() != found.files.size()) {
        traces = tracesOf(found.files);
    }
    noteElementsTwice(*contents.mesh, contents.activity, contents.findings);
    notePiece(found, path, contents.findings);
    contents.indexSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    contents.format = found.format->name;
    contents.path = found.files.front();
    contents.alone = contents.alone || settings.onlyThisFile;
    contents.files = found.files;
    contents.bytes = bytesOf(traces);
    contents.written = lastWritten(traces);
    contents.sha256 = sha256OfSeries(found.files, execution);
    contents.fingerprint = feFingerprint(*found.format, contents.sha256, settings, contents.frame, contents.units);
    if (contents.alone) {
        // What is recorded of a result is the digest of all that lies there under its name.
        contents.sha256 = sha256OfSeries(feFiles(path), execution);
    }
    // Formats that can use a list of deaths have it among their files.
    if (const std::string list = deathListBeside(contents.path);
        !list.empty() && std::find(found.files.begin(), found.files.end(), list) == found.files.end()) {
        noteUnusedDeathList(list, contents.findings);
    }
    for (const std::string& other : found.others) {
        contents.findings.add({"fe.folder_others", "The folder holds further results, which were not read", {}},
                              {"fe.folder_others.remedy", "Give the file of the one that you want.", {}}, other);
    }
    return std::make_shared<const FeResult>(std::move(contents));
}

std::vector<std::string> feFiles(const std::string& path, bool alone) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return findFe(path, false).files;
    }
    FoundFe found = findFeAt(path, readHead(path));
    if (found.format && alone) {
        return onlyFile(found, path).files;
    }
    return found.format ? found.files : std::vector<std::string>{path};
}

bool hasGrown(const FeResult& fe) {
    std::error_code error;
    if (!fs::exists(fe.contents().path, error)) {
        return false;
    }
    const std::vector<std::string> files = feFiles(fe.contents().path, fe.contents().alone);
    const std::vector<FileTrace> traces = tracesOf(files);
    // HDF5 writes into room that it had set aside: the size may stay.
    return files != fe.contents().files || bytesOf(traces) != fe.contents().bytes || lastWritten(traces) != fe.contents().written;
}

FeGrowth growthBetween(const FeResult& before, const FeResult& after) {
    const auto dead = [](const FeResult& fe) {
        return static_cast<std::int64_t>(fe.mesh().elementCount() - fe.activity().activeCount(fe.stateCount() - 1));
    };
    return {static_cast<std::int64_t>(after.stateCount()) - static_cast<std::int64_t>(before.stateCount()),
            dead(after) - dead(before),
            static_cast<std::int64_t>(after.contents().bytes) - static_cast<std::int64_t>(before.contents().bytes)};
}

std::string sha256OfFe(const std::string& path, const Execution& execution) {
    return sha256OfSeries(feFiles(path), execution);
}

}  // namespace rubble::io
