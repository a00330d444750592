#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// What the file system says of a file without reading it. Programs can set the time of content, not that of the last change.
struct FileTrace {
    std::string path;  ///< absolute
    std::int64_t bytes = -1;
    std::int64_t contentNs = 0;  ///< time of the last change of content, ns
    std::int64_t changeNs = 0;   ///< time of the last change of content, name or rights, ns
    friend bool operator==(const FileTrace&, const FileTrace&) = default;
};

/// The files of a result as they were when a copy was made of them.
struct SeriesTrace {
    std::vector<FileTrace> files;
    std::string sha256;  ///< of the series
};

std::vector<FileTrace> tracesOf(const std::vector<std::string>& files);

/// Of all that are there.
std::uint64_t bytesOf(const std::vector<FileTrace>& traces);

/// ns, when the content of one of them was changed last; 0 where there is none.
std::int64_t lastWritten(const std::vector<FileTrace>& traces);

/// Whether both name the same files with the same sizes.
bool sameSizes(const std::vector<FileTrace>& a, const std::vector<FileTrace>& b);

/// Reads what was kept beside a copy; nothing if it is missing or damaged.
std::optional<SeriesTrace> readTrace(const std::string& path);
/// Throws WorldError.
void writeTrace(const std::string& path, const SeriesTrace& trace);

}  // namespace rubble::io
