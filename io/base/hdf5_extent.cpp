#include "io/base/hdf5_extent.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::size_t shortestBlock = 48;
// What a writer puts there that has not closed the file yet.
constexpr std::uint64_t undefinedEnd = std::uint64_t{1} << 62;

std::uint64_t littleEndian(const std::array<char, 96>& bytes, std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 8; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

[[noreturn]] void failCut(const Message& what) {
    throw ParseError(what, {"hdf5.cut.remedy", "Copy the file again, or wait until the analysis has finished writing it.", {}});
}

}  // namespace

std::optional<std::uint64_t> hdf5End(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        failToRead(path);
    }
    std::array<char, 96> head{};
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    const auto got = static_cast<std::size_t>(file.gcount());
    const std::string_view seen(head.data(), std::min(got, hdf5Signature.size()));
    if (seen != hdf5Signature.substr(0, seen.size())) {
        return std::nullopt;
    }
    if (got < shortestBlock) {
        failCut({"hdf5.cut", "{0} is cut off: it ends after {1} bytes, inside its header", {path, static_cast<std::int64_t>(got)}});
    }
    const int version = head[8];
    const int offsetBytes = version < 2 ? head[13] : head[9];
    if (version < 0 || version > 3 || offsetBytes != 8) {
        return std::nullopt;
    }
    const std::uint64_t end = littleEndian(head, version == 0 ? 40 : version == 1 ? 44 : 28);
    return end < undefinedEnd ? std::optional(end) : std::nullopt;
}

void requireWholeHdf5(const std::string& path) {
    const auto end = hdf5End(path);
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (end && !error && *end > size) {
        failCut({"hdf5.cut.of",
                 "{0} is cut off: it ends after {1} of {2} bytes",
                 {path, static_cast<std::int64_t>(size), static_cast<std::int64_t>(*end)}});
    }
}

}  // namespace rubble::io
