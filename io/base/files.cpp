#include "io/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>
#include <streambuf>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/small_letters.h"
#include "io/base/sha256.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// Why a file cannot be read, as an error number of the system: streams do not say.
int reasonNotToRead(const std::string& path) {
    struct stat about{};
    if (::stat(path.c_str(), &about) != 0) {
        return errno;
    }
    if (S_ISDIR(about.st_mode)) {
        return EISDIR;
    }
    return ::access(path.c_str(), R_OK) != 0 ? errno : EIO;
}

[[noreturn]] void failWrite(const std::string& path, int error) {
    failToWrite(path, systemReason(error));
}

// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return m_fd; }
    int close() {
        const int fd = std::exchange(m_fd, -1);
        return fd < 0 ? 0 : ::close(fd);
    }

private:
    int m_fd;
};

// Buffers writes to a descriptor and remembers why one failed, which a standard file stream forgets.
class DescriptorBuffer : public std::streambuf {
public:
    explicit DescriptorBuffer(int fd) : m_fd(fd), m_buffer(std::size_t{1} << 16) {
        setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
    }
    int error() const { return m_error; }

protected:
    int_type overflow(int_type character) override {
        if (!flush()) {
            return traits_type::eof();
        }
        if (!traits_type::eq_int_type(character, traits_type::eof())) {
            sputc(traits_type::to_char_type(character));
        }
        return traits_type::not_eof(character);
    }
    int sync() override { return flush() ? 0 : -1; }

private:
    bool flush() {
        const char* from = pbase();
        while (from < pptr()) {
            const ssize_t written = ::write(m_fd, from, static_cast<std::size_t>(pptr() - from));
            if (written < 0 && errno == EINTR) {
                continue;
            }
            if (written <= 0) {
                m_error = written < 0 ? errno : ENOSPC;
                return false;
            }
            from += written;
        }
        setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
        return true;
    }

    int m_fd;
    int m_error = 0;
    std::vector<char> m_buffer;
};

// Writing through a link must change the file it points to, not replace the link.
std::string targetOf(const std::string& path) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored)) {
        const fs::path real = fs::weakly_canonical(path, ignored);
        return ignored ? path : real.string();
    }
    return path;
}

struct RemoveUnlessKept {
    std::string path;
    bool kept = false;
    ~RemoveUnlessKept() {
        if (!kept) {
            ::unlink(path.c_str());
        }
    }
};

// Libraries do not say why a file cannot be made: the system does.
void requireWritable(const std::string& path, const std::string& temporary) {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0) {
        failWrite(path, errno);
    }
    file.close();
    ::unlink(temporary.c_str());
}

void flushFolder(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    const Descriptor handle(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (handle.get() >= 0) {
        ::fsync(handle.get());
    }
}

}  // namespace

// strerror() follows the locale; messages are English until the window translates them.
std::string systemReason(int error) {
    const char* text = strerrordesc_np(error);
    return text ? text : "unknown reason";
}

void failToRead(const std::string& path, int error) {
    const int reason = error != 0 ? error : reasonNotToRead(path);
    throw WorldError(Message{"io.file.unreadable", "Cannot read {0}: {1}", {path, systemReason(reason)}},
                     Message{"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
}

void failToWrite(const std::string& path, const std::string& reason) {
    throw WorldError(
        Message{"io.file.unwritable", "Cannot write {0}: {1}", {path, reason}},
        Message{"io.file.unwritable.remedy",
                "Check free space and rights of the folder, or choose another place; what was there before is unchanged.",
                {}});
}

std::string sha256OfFile(const std::string& path, const std::function<void(std::size_t)>& advance) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) {
        failToRead(path, errno);
    }
    Sha256 digest;
    std::vector<unsigned char> block(std::size_t{1} << 16);
    for (;;) {
        const ssize_t got = ::read(file.get(), block.data(), block.size());
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            failToRead(path, errno);
        }
        if (got == 0) {
            break;
        }
        digest.add(block.data(), static_cast<std::size_t>(got));
        if (advance) {
            advance(static_cast<std::size_t>(got));
        }
    }
    return digest.hex();
}

std::string sha256OfText(std::string_view text) {
    Sha256 digest;
    digest.add(text.data(), text.size());
    return digest.hex();
}

void writeAtomically(const std::string& path, const std::function<void(std::ostream&)>& write) {
    const std::string target = targetOf(path);
    RemoveUnlessKept temporary{unfinishedName(target)};
    Descriptor file(::open(temporary.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0) {
        temporary.kept = true;
        failWrite(path, errno);
    }
    struct stat before{};
    if (::stat(target.c_str(), &before) == 0) {
        if (S_ISDIR(before.st_mode)) {
            failWrite(path, EISDIR);
        }
        // The new file keeps the rights of the old one where the file system lets it.
        (void)!::fchmod(file.get(), before.st_mode & 07777);
    }
    DescriptorBuffer buffer(file.get());
    std::ostream stream(&buffer);
    stream.imbue(std::locale::classic());
    write(stream);
    stream.flush();
    if (!stream) {
        failWrite(path, buffer.error() ? buffer.error() : EIO);
    }
    if (::fsync(file.get()) != 0 || file.close() != 0 || ::rename(temporary.path.c_str(), target.c_str()) != 0) {
        failWrite(path, errno);
    }
    temporary.kept = true;
    flushFolder(target);
}

void writeFileAtomically(const std::string& path, const std::function<void(const std::string&)>& write) {
    const std::string target = targetOf(path);
    if (std::error_code ignored; fs::is_directory(target, ignored)) {
        failWrite(path, EISDIR);
    }
    RemoveUnlessKept temporary{unfinishedName(target)};
    requireWritable(path, temporary.path);
    write(temporary.path);
    Descriptor file(::open(temporary.path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fsync(file.get()) != 0 || file.close() != 0 || ::rename(temporary.path.c_str(), target.c_str()) != 0) {
        failWrite(path, errno);
    }
    temporary.kept = true;
    flushFolder(target);
}

std::optional<std::string> contentOf(const std::string& path) {
    constexpr std::uintmax_t sizeLimit = std::uintmax_t{4} << 30;
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed || size > sizeLimit) {
        return {};
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return {};
    }
    std::string content(static_cast<std::size_t>(size), '\0');
    stream.read(content.data(), static_cast<std::streamsize>(size));
    if (stream.bad()) {
        return {};
    }
    content.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    return content;
}

void makeFolder(const std::string& path) {
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed) {
        throw WorldError({"io.cache.folder", "The folder {0} cannot be made: {1}", {path, systemReason(failed.value())}},
                         {"io.cache.folder.remedy", "Name another folder, or check its rights.", {}});
    }
}

void makeFolderOf(const std::string& path) {
    // Of a bare name the folder is where the program runs; a slash at the end of a folder would be made as one more.
    makeFolder(fs::absolute(path).lexically_normal().parent_path().string());
}

void writeIn(const std::string& path, std::string_view content) {
    makeFolderOf(path);
    writeAtomically(path, [&](std::ostream& out) { out.write(content.data(), static_cast<std::streamsize>(content.size())); });
}

// Unique within the machine: process and a counter.
std::string unfinishedName(const std::string& path) {
    static std::atomic<unsigned> counter{0};
    return path + "." + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
}

bool hasEnding(std::string_view path, std::string_view ending) {
    return path.size() >= ending.size() && inSmallLetters(path.substr(path.size() - ending.size())) == ending;
}

void writeProvenance(const std::string& exportedPath, std::string_view text) {
    writeAtomically(exportedPath + ".provenance.json", [&](std::ostream& out) { out << text << '\n'; });
}

}  // namespace rubble::io
