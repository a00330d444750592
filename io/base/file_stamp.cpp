#include "io/base/file_stamp.h"

#include <sys/stat.h>

#include <chrono>

namespace rubble::io {

std::optional<FileStamp> settledStamp(const std::string& path) {
    using namespace std::chrono;
    constexpr seconds settles(3);
    struct stat found{};
    if (::stat(path.c_str(), &found) != 0) {
        return std::nullopt;
    }
    const nanoseconds changed = seconds(found.st_mtim.tv_sec) + nanoseconds(found.st_mtim.tv_nsec);
    if (system_clock::now().time_since_epoch() - changed < settles) {
        return std::nullopt;
    }
    return FileStamp{found.st_dev, found.st_ino, found.st_size, changed.count()};
}

}  // namespace rubble::io
