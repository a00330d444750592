#include "io/run/checkpoint_file.h"

#include <chrono>
#include <filesystem>
#include <vector>

#include "io/base/files.h"
#include "io/base/machine.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// What nobody has written to for so long is not being written.
constexpr std::chrono::minutes abandonedAfter{10};

}  // namespace

CheckpointFile::CheckpointFile(std::string path) : m_path(std::move(path)), m_interval(checkpointSeconds()) {}

std::optional<std::string> CheckpointFile::latest() {
    removeUnfinished();
    return contentOf(m_path);
}

void CheckpointFile::keep(std::string_view checkpoint) {
    writeIn(m_path, checkpoint);
}

void CheckpointFile::remove() {
    std::error_code ignored;
    fs::remove(m_path, ignored);
    removeUnfinished();
}

void CheckpointFile::removeUnfinished() const {
    const fs::path path(m_path);
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
