#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

#include "core/base/error.h"
#include "core/fe/audit.h"

namespace rubble {

/// A folder of this process's own, made once.
inline const std::filesystem::path& fuzzFolder() {
    static const std::filesystem::path folder = [] {
        std::filesystem::path made = std::filesystem::temp_directory_path() / ("rubble-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directory(made);
        return made;
    }();
    return folder;
}

/// One thread: waking others takes longer than reading what fits into a corpus.
inline const Execution& fuzzExecution() {
    static const Execution execution = Execution{}.withThreads(1);
    return execution;
}

/// Lays bytes down as a file of the folder. @return its path
inline std::string layDown(const char* bytes, std::size_t size, const std::string& name) {
    std::string path = (fuzzFolder() / name).string();
    std::ofstream(path, std::ios::binary | std::ios::trunc).write(bytes, static_cast<std::streamsize>(size));
    return path;
}

inline std::string layDown(const std::uint8_t* bytes, std::size_t size, const std::string& name) {
    return layDown(reinterpret_cast<const char*>(bytes), size, name);
}

/// Takes what a reader gives, as openFe() would, and reads all of it. Errors of ours are answers; anything else is a finding.
inline void fuzzResult(const std::function<FeResult::Contents()>& read) {
    try {
        FeResult::Contents contents = read();
        const auto& times = contents.times;
        const bool rising =
            std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); }) == times.end();
        if (rising && !times.empty() && times.front() == times.front()) {
            // openFe() refuses all others.
            const FeResult fe(std::move(contents));
            for (std::size_t k = 0; k < fe.stateCount(); ++k) {
                fe.state(k);
            }
            auditDeaths(fe, groupComponents(fe.mesh(), {}, {}, {}), fuzzExecution());
        }
    } catch (const Error&) {
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
        // openFe() says of both that the file asks for more memory than there is.
    }
}

/// Lays any bytes down as a file and gives it to a reader.
inline void fuzzFile(const std::uint8_t* bytes, std::size_t size, const std::string& name,
                     const std::function<FeResult::Contents(const std::string&)>& read) {
    const std::string path = layDown(bytes, size, name);
    fuzzResult([&] { return read(path); });
}

}  // namespace rubble
