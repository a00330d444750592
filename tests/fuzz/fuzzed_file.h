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

/// Lays any bytes down as a file in a folder of this process's own and gives it to a reader. Errors of ours are answers; anything
/// else is a finding.
inline void fuzzFile(const std::uint8_t* bytes, std::size_t size, const std::string& name,
                     const std::function<FeResult::Contents(const std::string&)>& read) {
    static const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("rubble-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const std::string path = (folder / name).string();
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    try {
        FeResult::Contents contents = read(path);
        const auto& times = contents.times;
        const bool rising =
            std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); }) == times.end();
        if (rising && !times.empty() && times.front() == times.front()) {
            // openFe() refuses all others.
            const FeResult fe(std::move(contents));
            for (std::size_t k = 0; k < fe.stateCount(); ++k) {
                fe.state(k);
            }
            auditDeaths(fe, groupComponents(fe.mesh(), {}, {}, {}), Execution{});
        }
    } catch (const Error&) {
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
        // openFe() says of both that the file asks for more memory than there is.
    }
}

}  // namespace rubble
