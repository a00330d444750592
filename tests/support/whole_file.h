#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/places.h"

namespace rubble::io {

/// All that a file holds; empty if it cannot be read.
inline std::string wholeFile(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Makes a file hold these bytes and no others.
inline void writeContent(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Where a file of the unpacked FE results lies.
inline std::string fixture(const std::string& name) {
    return buildPath("tests/fe/") + name;
}

}  // namespace rubble::io
