#include "io/site/clouds/cloud_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/base/file_words.h"
#include "io/base/files.h"

namespace rubble::io {

CloudFile::CloudFile(const std::string& path) : m_path(path), m_handle(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat about{};
    const bool there = m_handle >= 0 && ::fstat(m_handle, &about) == 0 && S_ISREG(about.st_mode);
    if (!there) {
        if (m_handle >= 0) {
            ::close(m_handle);
        }
        throw WorldError({"cloud.missing", "There is no point cloud {0} that may be read", {path}},
                         {"cloud.missing.remedy", "Check that the file exists and that you may read it.", {}});
    }
    m_size = static_cast<std::uint64_t>(about.st_size);
    if (m_size == 0) {
        ::close(m_handle);
        refuseContent({"cloud.empty", "{0} is empty", {path}}, "Copy it again from where it came.");
    }
}

CloudFile::~CloudFile() {
    ::close(m_handle);
}

std::size_t CloudFile::readSome(std::uint64_t at, unsigned char* target, std::size_t count) const {
    std::size_t done = 0;
    while (done < count && at + done < m_size) {
        const ssize_t got = ::pread(m_handle, target + done, count - done, static_cast<off_t>(at + done));
        if (got == 0) {
            break;
        }
        if (got < 0 && errno != EINTR) {
            throw WorldError({"cloud.unreadable", "{0} cannot be read: {1}", {m_path, systemReason(errno)}},
                             {"cloud.unreadable.remedy", "Check the disk that it lies on, or copy it to another.", {}});
        }
        done += got > 0 ? static_cast<std::size_t>(got) : 0;
    }
    return done;
}

void CloudFile::read(std::uint64_t at, unsigned char* target, std::size_t count) const {
    if (readSome(at, target, count) != count) {
        failCut();
    }
}

std::vector<unsigned char> CloudFile::bytes(std::uint64_t at, std::uint64_t count) const {
    if (at > m_size || count > m_size - at) {
        failCut();
    }
    std::vector<unsigned char> all(static_cast<std::size_t>(count));
    read(at, all.data(), all.size());
    return all;
}

void CloudFile::failCut() const {
    refuseContent({"cloud.cut", "{0} promises more than it holds", {m_path}},
                  "The file may be cut short: copy it again from where it came.");
}

}  // namespace rubble::io
