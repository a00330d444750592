#include "io/run/checkpoint_file.h"

#include <filesystem>

#include "io/base/abandoned.h"
#include "io/base/files.h"
#include "io/base/machine.h"

namespace rubble::io {

namespace fs = std::filesystem;

CheckpointFile::CheckpointFile(std::string path) : m_path(std::move(path)), m_interval(checkpointSeconds()) {}

std::optional<std::string> CheckpointFile::latest() {
    removeAbandoned(m_path);
    return contentOf(m_path);
}

void CheckpointFile::keep(std::string_view checkpoint) {
    writeIn(m_path, checkpoint);
}

void CheckpointFile::remove() {
    std::error_code ignored;
    fs::remove(m_path, ignored);
    removeAbandoned(m_path);
}

}  // namespace rubble::io
