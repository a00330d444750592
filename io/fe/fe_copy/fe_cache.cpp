#include "io/fe/fe_copy/fe_cache.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/fe/fe_copy/copy_reader.h"
#include "io/fe/fe_copy/copy_writer.h"
#include "io/fe/fe_copy/file_traces.h"
#include "io/fe/fe_reader.h"
#include "io/fe/fe_search.h"
#include "io/fe/series_digest.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// Where a copy lies, and what belongs to it.
struct CachePlace {
    std::string copy;
    std::string trace;
    std::string lock;
    std::string damaged;  ///< there if a state of the copy was found to be damaged

    CachePlace(const std::string& folder, const FoundFe& found, const ImportSettings& settings, const Frame& frame) {
        const std::string path = fs::absolute(found.files.front()).lexically_normal().string();
        Hasher hasher;
        hasher.digest(feFingerprint(*found.format, path, settings, frame, {}));
        hasher.value(frame.metresPerUnit).text(unitChoices()[settings.units]).text(upAxisChoices()[settings.upAxis]);
        const fs::path stem = fs::path(folder) / "fe" / hasher.finish().hex();
        copy = stem.string() + ".h5";
        trace = stem.string() + ".json";
        lock = stem.string() + ".lock";
        damaged = stem.string() + ".damaged";
    }
};

/// Only one program makes a copy at a time; the lock goes with its holder.
class CacheLock {
public:
    CacheLock(const std::string& path, const Execution& execution)
        : m_file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        while (m_file >= 0 && ::flock(m_file, LOCK_EX | LOCK_NB) != 0) {
            execution.report({"fe_cache.wait", "Another program makes the copy", {}}, 0.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }
    ~CacheLock() {
        if (m_file >= 0) {
            ::close(m_file);
        }
    }
    CacheLock(const CacheLock&) = delete;
    CacheLock& operator=(const CacheLock&) = delete;

private:
    int m_file;
};

/// States from the copy; should one be damaged, from the result itself from then on.
class CachedSource : public StateSource {
public:
    CachedSource(std::shared_ptr<const StateSource> copy, CachePlace place, FoundFe found, std::string sha256,
                 ImportSettings settings, Frame frame)
        : m_copy(std::move(copy)),
          m_place(std::move(place)),
          m_found(std::move(found)),
          m_sha256(std::move(sha256)),
          m_settings(std::move(settings)),
          m_frame(std::move(frame)) {}

    FeState read(std::size_t k) const override {
        try {
            return m_copy->read(k);
        } catch (const ParseError&) {
            std::ofstream(m_place.damaged, std::ios::trunc);
            return original().read(k);
        }
    }

private:
    const StateSource& original() const {
        const std::scoped_lock lock(m_mutex);
        if (!m_original) {
            m_original = openFe(m_found.files.front(), m_settings, m_frame, Execution{});
            if (m_original->contents().sha256 != m_sha256) {
                throw ParseError({"fe_cache.gone", "{0} is no longer what it was when it was opened", {m_found.files.front()}},
                                 {"fe_cache.gone.remedy", "Open the result again.", {}});
            }
        }
        return *m_original->contents().source;
    }

    std::shared_ptr<const StateSource> m_copy;
    const CachePlace m_place;
    const FoundFe m_found;
    const std::string m_sha256;
    const ImportSettings m_settings;
    const Frame m_frame;
    mutable std::mutex m_mutex;
    mutable std::shared_ptr<const FeResult> m_original;
};

/// One opening through the cache.
class CachedOpening {
public:
    CachedOpening(const FoundFe& found, const ImportSettings& settings, const Frame& frame, const Execution& execution,
                  const std::string& folder)
        : m_found(found),
          m_settings(settings),
          m_frame(frame),
          m_execution(execution),
          m_place(folder, found, settings, frame),
          m_begun(std::chrono::steady_clock::now()) {}

    std::shared_ptr<const FeResult> open(const std::string& path) {
        notePiece(m_found, path, m_given);
        if (auto kept = fromCopy()) {
            return kept;
        }
        std::error_code error;
        fs::create_directories(fs::path(m_place.copy).parent_path(), error);
        const CacheLock lock(m_place.lock, m_execution);
        // Another program may have made it in the meantime.
        if (auto kept = fromCopy()) {
            return kept;
        }
        const std::vector<FileTrace> before = tracesOf(m_found.files);
        const auto fe = openFe(path, m_settings, m_frame, m_execution);
        // A file that was opened without the others of its series, or as a piece, is not what the copy stands for.
        if (fe->contents().files == m_found.files && m_given.empty()) {
            keep(*fe, before);
        }
        if (m_findings.empty()) {
            return fe;
        }
        FeResult::Contents contents = fe->contents();
        contents.findings.append(m_findings);
        return std::make_shared<const FeResult>(std::move(contents));
    }

private:
    void noteDamage(const std::string& what) {
        m_findings.add({"fe_cache.damaged", "The copy of the result in the cache was damaged and is made again", {}},
                       {"fe_cache.damaged.remedy", "Check the disk if this is said again.", {}}, what);
        std::error_code ignored;
        for (const std::string& file : {m_place.copy, m_place.trace, m_place.damaged}) {
            fs::remove(file, ignored);
        }
    }

    std::shared_ptr<const FeResult> fromCopy() {
        std::error_code ignored;
        if (fs::exists(m_place.damaged, ignored)) {
            noteDamage(m_place.copy);
        }
        if (!fs::exists(m_place.copy, ignored)) {
            return nullptr;
        }
        const std::vector<FileTrace> now = tracesOf(m_found.files);
        const std::optional<SeriesTrace> trace = readTrace(m_place.trace);
        if (trace && !sameSizes(trace->files, now)) {
            return nullptr;
        }
        try {
            FeCopy copy = openFeCopy(m_place.copy);
            const bool untouched = trace && trace->files == now && trace->sha256 == copy.about.sha256;
            if (!untouched) {
                if (sha256OfSeries(m_found.files, m_execution) != copy.about.sha256) {
                    return nullptr;
                }
                rememberTrace({now, copy.about.sha256});
            }
            return resultOf(std::move(copy));
        } catch (const Error& error) {
            noteDamage(error.what());
            return nullptr;
        }
    }

    // Without it the next opening takes the digest again.
    void rememberTrace(const SeriesTrace& trace) const {
        try {
            writeTrace(m_place.trace, trace);
        } catch (const WorldError&) {
        }
    }

    std::shared_ptr<const FeResult> resultOf(FeCopy copy) {
        FeResult::Contents& contents = copy.contents;
        contents.format = m_found.format->name;
        contents.path = m_found.files.front();
        contents.files = m_found.files;
        const std::vector<FileTrace> traces = tracesOf(m_found.files);
        contents.bytes = bytesOf(traces);
        contents.written = lastWritten(traces);
        contents.sha256 = copy.about.sha256;
        contents.frame = copy.about.frame;
        // Nothing in the copy depends on the coordinate system: it may have been given to the case since.
        contents.frame.crs = m_frame.crs;
        contents.units = copy.about.units;
        contents.unitsFrom = copy.about.unitsFrom;
        contents.fingerprint = feFingerprint(*m_found.format, contents.sha256, m_settings, contents.frame, contents.units);
        contents.findings.append(m_findings);
        contents.findings.append(m_given);
        contents.source =
            std::make_shared<const CachedSource>(contents.source, m_place, m_found, contents.sha256, m_settings, m_frame);
        contents.indexSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begun).count();
        return std::make_shared<const FeResult>(std::move(contents));
    }

    // A result that grows while it is read is not kept: what was read and what was hashed may differ.
    // A table of bodies opens at once, and a copy would not know that its bodies are loose.
    void keep(const FeResult& fe, const std::vector<FileTrace>& before) {
        if (fe.contents().looseBodies) {
            return;
        }
        try {
            writeFileAtomically(m_place.copy, [&](const std::string& file) { writeFeCopy(file, fe, Vec3::Zero(), m_execution); });
            if (tracesOf(m_found.files) == before) {
                writeTrace(m_place.trace, {before, fe.contents().sha256});
            } else {
                std::error_code ignored;
                fs::remove(m_place.copy, ignored);
            }
        } catch (const WorldError& error) {
            m_findings.add(
                {"fe_cache.not_kept", "The copy of the result could not be kept in the cache", {}},
                {"fe_cache.not_kept.remedy", "Make room for the cache (rubble-cli cache clear), or name another folder.", {}},
                error.what());
        }
    }

    const FoundFe& m_found;
    const ImportSettings& m_settings;
    const Frame& m_frame;
    const Execution& m_execution;
    const CachePlace m_place;
    const std::chrono::steady_clock::time_point m_begun;
    Findings m_findings;
    Findings m_given;  // what is said of the file that was given
};

// Of all files in a folder and below.
void addFiles(const fs::path& folder, CacheEntry& entry) {
    std::error_code ignored;
    for (fs::recursive_directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        std::error_code failed;
        const std::uintmax_t size = it->is_regular_file(failed) ? it->file_size(failed) : 0;
        if (!failed && it->is_regular_file(failed)) {
            ++entry.files;
            entry.bytes += size;
        }
    }
}

// A copy and what belongs to it are one entry.
std::vector<CacheEntry> copiesIn(const fs::path& folder) {
    std::vector<CacheEntry> entries;
    std::error_code ignored;
    std::vector<fs::path> paths;
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        if (it->path().extension() == ".h5") {
            paths.push_back(it->path());
        }
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        const std::optional<SeriesTrace> trace = readTrace(fs::path(path).replace_extension(".json").string());
        CacheEntry entry{"fe", trace && !trace->files.empty() ? trace->files.front().path : path.string(), 1, 0};
        std::error_code failed;
        const std::uintmax_t size = fs::file_size(path, failed);
        entry.bytes = failed ? 0 : size;
        entries.push_back(std::move(entry));
    }
    std::stable_sort(entries.begin(), entries.end(), [](const CacheEntry& a, const CacheEntry& b) { return a.bytes > b.bytes; });
    return entries;
}

}  // namespace

std::shared_ptr<const FeResult> openFeCached(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                             const Execution& execution, const std::string& folder) {
    const FoundFe found = findFe(path, settings.onlyThisFile);
    if (found.format->recognises == recognisesFeCopy || settings.onlyThisFile) {
        return openFe(path, settings, frame, execution);
    }
    return CachedOpening(found, settings, frame, execution, folder).open(path);
}

const std::vector<std::string>& cacheKinds() {
    static const std::vector<std::string> kinds{"fe", "worlds", "islands", "checkpoints", "costs", "points", "calibration"};
    return kinds;
}

std::vector<CacheEntry> cacheEntries(const std::string& folder) {
    std::vector<CacheEntry> entries = copiesIn(fs::path(folder) / "fe");
    for (const std::string& kind : cacheKinds()) {
        CacheEntry entry{kind, "", 0, 0};
        addFiles(fs::path(folder) / kind, entry);
        if (kind != "fe" && entry.files > 0) {
            entries.push_back(std::move(entry));
        }
    }
    return entries;
}

std::vector<CacheEntry> clearCache(const std::string& folder, const std::vector<std::string>& kinds) {
    std::vector<CacheEntry> removed;
    for (const std::string& kind : cacheKinds()) {
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
            continue;
        }
        CacheEntry entry{kind, "", 0, 0};
        addFiles(fs::path(folder) / kind, entry);
        std::error_code error;
        fs::remove_all(fs::path(folder) / kind, error);
        if (error) {
            throw WorldError(
                {"fe_cache.clear", "{0} cannot be removed: {1}", {(fs::path(folder) / kind).string(), error.message()}},
                {"fe_cache.clear.remedy", "Check the rights of the folder.", {}});
        }
        if (entry.files > 0) {
            removed.push_back(std::move(entry));
        }
    }
    return removed;
}

}  // namespace rubble::io
