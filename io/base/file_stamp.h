#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace rubble::io {

/// By what a file is known again as long as nobody writes into it.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t number = 0;  ///< on its device
    std::int64_t size = 0;     ///< bytes
    std::int64_t changed = 0;  ///< ns since 1970, of its last change

    auto operator<=>(const FileStamp&) const = default;
};

/// Nothing if there is no such file, or if it changed so lately that a further change could leave the stamp as it is: file
/// systems tell times in steps of some milliseconds, remote ones of a second.
std::optional<FileStamp> settledStamp(const std::string& path);

}  // namespace rubble::io
