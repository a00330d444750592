#include "io/base/abandoned.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// What nobody has written to for so long is not being written.
constexpr std::chrono::minutes abandonedAfter{10};

}  // namespace

void removeAbandoned(const std::string& file) {
    const fs::path path = fs::absolute(file);
    const std::string stem = path.filename().string() + ".";
    std::error_code ignored;
    std::vector<fs::path> abandoned;
    for (fs::directory_iterator it(path.parent_path(), ignored), end; it != end; it.increment(ignored)) {
        const std::string name = it->path().filename().string();
        if (name.starts_with(stem) && name.ends_with(".part") &&
            fs::file_time_type::clock::now() - it->last_write_time(ignored) > abandonedAfter) {
            abandoned.push_back(it->path());
        }
    }
    for (const fs::path& each : abandoned) {
        fs::remove(each, ignored);
    }
}

}  // namespace rubble::io
