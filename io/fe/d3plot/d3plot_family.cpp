#include "io/fe/d3plot/d3plot_family.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/fe/d3plot/d3plot_header.h"
#include "io/fe/fe_format.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t chunkBytes = std::int64_t{1} << 20;

template <class Word>
Word wordOf(const unsigned char* bytes, bool bigEndian) {
    std::array<unsigned char, sizeof(Word)> order;
    std::copy_n(bytes, sizeof(Word), order.begin());
    if (bigEndian != (std::endian::native == std::endian::big)) {
        std::reverse(order.begin(), order.end());
    }
    return std::bit_cast<Word>(order);
}

bool allDigits(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Members are numbered with two digits up to 99, then with as many as it takes.
std::optional<int> memberNumber(const std::string& name, const std::string& root) {
    if (!name.starts_with(root)) {
        return std::nullopt;
    }
    const std::string digits = name.substr(root.size());
    const bool proper =
        allDigits(digits) && digits.size() >= 2 && digits.size() <= 6 && (digits.size() == 2 || digits.front() != '0');
    return proper ? std::optional(std::stoi(digits)) : std::nullopt;
}

std::map<int, std::string> numberedFiles(const fs::path& root) {
    std::map<int, std::string> files;
    const std::string rootName = root.filename().string();
    const fs::path folder = root.parent_path();
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        if (const auto number = memberNumber(entry->path().filename().string(), rootName); number && *number > 0) {
            files[*number] = (folder / entry->path().filename()).string();
        }
    }
    return files;
}

std::string rootOf(const std::string& path) {
    const std::string folder = path.substr(0, path.size() - fs::path(path).filename().string().size());
    const std::string name = fs::path(path).filename().string();
    const std::size_t digits = name.size() - (name.find_last_not_of("0123456789") + 1);
    std::error_code ignored;
    for (std::size_t taken = 2; taken <= digits && taken < name.size(); ++taken) {
        const std::string root = name.substr(0, name.size() - taken);
        if (memberNumber(name, root) && fs::is_regular_file(folder + root, ignored) && isD3plotRoot(folder + root)) {
            return folder + root;
        }
    }
    return path;
}

}  // namespace

double floatOfWord(const unsigned char* bytes, WordFormat format) {
    return format.bytes == 4 ? static_cast<double>(wordOf<float>(bytes, format.bigEndian))
                             : wordOf<double>(bytes, format.bigEndian);
}

std::int64_t integerOfWord(const unsigned char* bytes, WordFormat format) {
    return format.bytes == 4 ? wordOf<std::int32_t>(bytes, format.bigEndian) : wordOf<std::int64_t>(bytes, format.bigEndian);
}

/// A file that is open for reading.
class D3plotFamily::Handle {
public:
    explicit Handle(const std::string& path) : m_descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~Handle() {
        if (valid()) {
            ::close(m_descriptor);
        }
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    bool valid() const { return m_descriptor >= 0; }

    /// Reads as much of what is asked for as the file has.
    std::size_t read(unsigned char* to, std::size_t count, std::int64_t from) const {
        std::size_t done = 0;
        while (done < count) {
            const ssize_t got = ::pread(m_descriptor, to + done, count - done, static_cast<off_t>(from) + static_cast<off_t>(done));
            if (got < 0 && errno == EINTR) {
                continue;
            }
            if (got <= 0) {
                break;
            }
            done += static_cast<std::size_t>(got);
        }
        return done;
    }

private:
    int m_descriptor;
};

D3plotFamily::~D3plotFamily() = default;

D3plotFamily::D3plotFamily(std::vector<std::string> files, WordFormat format) : m_files(std::move(files)), m_format(format) {
    m_first.push_back(0);
    for (const std::string& file : m_files) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(file, error);
        if (error) {
            failToRead(file);
        }
        m_first.push_back(m_first.back() + static_cast<std::int64_t>(size) / format.bytes);
    }
}

std::size_t D3plotFamily::fileOf(std::int64_t word) const {
    const auto next = std::upper_bound(m_first.begin(), m_first.end(), word);
    const auto file = static_cast<std::size_t>(next - m_first.begin());
    return std::min(file == 0 ? 0 : file - 1, m_files.size() - 1);
}

std::string D3plotFamily::fileName(std::size_t file) const {
    return fs::path(m_files[file]).filename().string();
}

std::string D3plotFamily::placeOf(std::int64_t word) const {
    const std::size_t file = fileOf(word);
    return fileName(file) + ", byte " + englishInteger((word - m_first[file]) * m_format.bytes);
}

std::shared_ptr<const D3plotFamily::Handle> D3plotFamily::handleOf(std::size_t file) const {
    const std::scoped_lock lock(m_mutex);
    if (!m_handle || m_opened != file) {
        m_handle = std::make_shared<const Handle>(m_files[file]);
        m_opened = file;
        if (!m_handle->valid()) {
            m_handle.reset();
            throw WorldError({"d3plot.gone", "{0} cannot be read any more", {m_files[file]}},
                             {"fe.unreadable.remedy", "Check the path and that you may read the file.", {}});
        }
    }
    return m_handle;
}

void D3plotFamily::readBytes(std::int64_t word, std::span<unsigned char> bytes) const {
    assert(word >= 0 && word + static_cast<std::int64_t>(bytes.size()) / m_format.bytes <= words());
    std::size_t done = 0;
    std::int64_t from = (word - m_first[fileOf(word)]) * m_format.bytes;
    for (std::size_t file = fileOf(word); done < bytes.size(); ++file, from = 0) {
        const auto available = static_cast<std::size_t>(wordsOf(file) * m_format.bytes - from);
        const std::size_t count = std::min(bytes.size() - done, available);
        if (handleOf(file)->read(bytes.data() + done, count, from) != count) {
            throw ParseError({"d3plot.shrunk",
                              "{0} has become shorter since it was opened: it ends before byte {1}",
                              {m_files[file], from + static_cast<std::int64_t>(count)}},
                             {"d3plot.shrunk.remedy", "Open the result again.", {}});
        }
        done += count;
    }
}

template <class Value>
void D3plotFamily::readWords(std::int64_t word, std::span<Value> values, Value (*valueOf)(const unsigned char*, WordFormat)) const {
    std::vector<unsigned char> bytes;
    const auto chunk = static_cast<std::size_t>(chunkBytes / m_format.bytes);
    const auto width = static_cast<std::size_t>(m_format.bytes);
    for (std::size_t done = 0; done < values.size();) {
        const std::size_t count = std::min(chunk, values.size() - done);
        bytes.resize(count * width);
        readBytes(word + static_cast<std::int64_t>(done), bytes);
        for (std::size_t i = 0; i < count; ++i) {
            values[done + i] = valueOf(bytes.data() + i * width, m_format);
        }
        done += count;
    }
}

void D3plotFamily::readFloats(std::int64_t word, std::span<double> values) const {
    readWords(word, values, floatOfWord);
}

void D3plotFamily::readIntegers(std::int64_t word, std::span<std::int64_t> values) const {
    readWords(word, values, integerOfWord);
}

double D3plotFamily::readFloat(std::int64_t word) const {
    double value = 0.0;
    readFloats(word, {&value, 1});
    return value;
}

std::int64_t D3plotFamily::readInteger(std::int64_t word) const {
    std::int64_t value = 0;
    readIntegers(word, {&value, 1});
    return value;
}

std::string D3plotFamily::readText(std::int64_t word, std::int64_t words) const {
    std::vector<unsigned char> bytes(static_cast<std::size_t>(words * m_format.bytes));
    readBytes(word, bytes);
    std::string text(bytes.begin(), bytes.end());
    return text.substr(0, text.find('\0'));
}

bool isD3plotRoot(const std::string& path) {
    try {
        return recognisesD3plot(readHead(path));
    } catch (const Error&) {
        return false;
    }
}

std::vector<std::string> d3plotMembers(const std::string& path) {
    const std::string root = isD3plotRoot(path) ? path : rootOf(path);
    std::vector<std::string> members{root};
    int expected = 1;
    for (const auto& [number, file] : numberedFiles(root)) {
        if (number != expected++) {
            break;
        }
        members.push_back(file);
    }
    return members;
}

std::vector<std::string> d3plotLeftBehind(const std::string& root, std::size_t members) {
    std::vector<std::string> names;
    for (const auto& [number, file] : numberedFiles(root)) {
        if (number >= static_cast<int>(members)) {
            names.push_back(fs::path(file).filename().string());
        }
    }
    return names;
}

std::vector<std::string> d3plotRoots(const std::string& path) {
    constexpr std::size_t letters = 2;
    const auto isLater = [](const std::string& name, std::size_t from) {
        return name.size() == from + letters && std::all_of(name.begin() + static_cast<std::ptrdiff_t>(from), name.end(),
                                                            [](char c) { return c >= 'a' && c <= 'z'; });
    };
    std::string root = d3plotMembers(path).front();
    const std::string own = fs::path(root).filename().string();
    if (own.size() > letters && isLater(own, own.size() - letters) && isD3plotRoot(root.substr(0, root.size() - letters))) {
        root.resize(root.size() - letters);
    }
    const std::string base = fs::path(root).filename().string();
    std::vector<std::string> roots{root};
    for (const std::string& other : filesBeside(root)) {
        const std::string name = fs::path(other).filename().string();
        if (name.starts_with(base) && isLater(name, base.size()) && isD3plotRoot(root) && isD3plotRoot(other)) {
            roots.push_back(other);
        }
    }
    return roots;
}

}  // namespace rubble::io
