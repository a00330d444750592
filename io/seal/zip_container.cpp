#include "io/seal/zip_container.h"

#include <minizip/unzip.h>
#include <minizip/zip.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::uint64_t contentMost = std::uint64_t{64} << 20;
/// Stands for a number that is kept in the field of zip64.
constexpr std::uint64_t zip64Mark = 0xffffffffu;
constexpr uLong madeByUnix = (3u << 8) | 45u, namesInUtf8 = 1u << 11;

/// Every entry is a plain file that anybody may read, of no date.
bool openEntry(zipFile zip, const std::string& name, std::uint64_t bytes) {
    zip_fileinfo about{};
    about.dosDate = ((1u << 5) | 1u) << 16;  // the first of January 1980, where the dates of zip begin
    about.external_fa = 0100644u << 16;
    return zipOpenNewFileInZip4_64(zip, name.c_str(), &about, nullptr, 0, nullptr, 0, nullptr, 0, 0, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                   Z_DEFAULT_STRATEGY, nullptr, 0, madeByUnix, namesInUtf8, bytes >= zip64Mark ? 1 : 0) == ZIP_OK;
}

bool writeEntry(zipFile zip, const char* data, std::size_t size) {
    constexpr std::size_t most = std::size_t{1} << 30;
    while (size > 0) {
        const std::size_t part = std::min(size, most);
        if (zipWriteInFileInZip(zip, data, static_cast<unsigned>(part)) != ZIP_OK) {
            return false;
        }
        data += part;
        size -= part;
    }
    return true;
}

std::uint64_t littleEndian(const char* bytes, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < count; ++i) {
        number |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    }
    return number;
}

/// What the directory says of an entry.
struct DirectoryRecord {
    std::uint64_t place = 0;  ///< where its head begins
    std::uint64_t bytes = 0;  ///< not packed
    std::uint64_t packed = 0;
};

/// Reads a record of the directory; nothing if there is none there. Minizip 1.1 writes entries of 4 GiB and places beyond them, but
/// does not read them.
std::optional<DirectoryRecord> recordAt(std::ifstream& file, std::uint64_t at) {
    constexpr std::size_t recordBytes = 46;
    std::array<char, recordBytes> head{};
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(head.data(), head.size());
    if (!file || std::memcmp(head.data(), "PK\1\2", 4) != 0) {
        return {};
    }
    DirectoryRecord record{littleEndian(&head[42], 4), littleEndian(&head[24], 4), littleEndian(&head[20], 4)};
    std::vector<char> extra(littleEndian(&head[30], 2));
    file.seekg(static_cast<std::streamoff>(littleEndian(&head[28], 2)), std::ios::cur);
    file.read(extra.data(), static_cast<std::streamsize>(extra.size()));
    for (std::size_t field = 0; file && field + 4 <= extra.size();) {
        const std::size_t length = littleEndian(&extra[field + 2], 2);
        std::size_t next = field + 4;
        const std::size_t end = std::min(next + length, extra.size());
        if (littleEndian(&extra[field], 2) == 1) {
            for (std::uint64_t* number : {&record.bytes, &record.packed, &record.place}) {
                if (*number == zip64Mark && next + 8 <= end) {
                    *number = littleEndian(&extra[next], 8);
                    next += 8;
                }
            }
        }
        field += 4 + length;
    }
    return record;
}

[[noreturn]] void failDamaged(const std::string& path, const std::string& name) {
    throw ParseError(Message{"io.seal.entry_damaged", "{0}: {1} is damaged: it cannot be unpacked", {path, name}},
                     Message{"io.seal.damaged.remedy", "Get the bundle anew from whoever sealed it, or from another copy.", {}});
}

}  // namespace

ZipWriter::ZipWriter(const std::string& path) : m_path(path), m_zip(zipOpen64(path.c_str(), APPEND_STATUS_CREATE)) {
    if (m_zip == nullptr) {
        failToWrite(path, systemReason(errno));
    }
}

ZipWriter::~ZipWriter() {
    if (m_zip != nullptr) {
        zipClose(m_zip, nullptr);
    }
}

void ZipWriter::open(const std::string& name, std::uint64_t bytes) {
    if (++m_entries > zipEntriesMost) {
        throw UsageError(
            Message{"io.seal.too_many", "A bundle holds at most {0} files", {zipEntriesMost}},
            Message{"io.seal.too_many.remedy",
                    "Join an input of many files first (rubble-cli convert), or seal without it: rubble-cli seal --leave-out ID.",
                    {}});
    }
    errno = 0;
    if (!openEntry(m_zip, name, bytes)) {
        failToWrite(m_path, systemReason(errno != 0 ? errno : EIO));
    }
}

void ZipWriter::write(const char* data, std::size_t size) {
    errno = 0;
    if (!writeEntry(m_zip, data, size)) {
        failToWrite(m_path, systemReason(errno != 0 ? errno : EIO));
    }
}

void ZipWriter::close() {
    errno = 0;
    if (zipCloseFileInZip(m_zip) != ZIP_OK) {
        failToWrite(m_path, systemReason(errno != 0 ? errno : EIO));
    }
}

void ZipWriter::add(const std::string& name, std::string_view content) {
    open(name, content.size());
    write(content.data(), content.size());
    close();
}

void ZipWriter::finish() {
    errno = 0;
    void* const zip = m_zip;
    m_zip = nullptr;
    if (zipClose(zip, nullptr) != ZIP_OK) {
        failToWrite(m_path, systemReason(errno != 0 ? errno : EIO));
    }
}

ZipReader::ZipReader(const std::string& path) : m_path(path), m_zip(nullptr) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 4> head{};
    if (std::error_code ignored; !file || std::filesystem::is_directory(path, ignored)) {
        failToRead(path);
    }
    file.read(head.data(), head.size());
    if (std::memcmp(head.data(), "PK\3\4", head.size()) != 0) {
        throw ParseError(
            Message{"io.seal.no_container", "{0} is no sealed bundle: it does not begin as a zip container does", {path}},
            Message{"io.seal.no_container.remedy", "Name a file that rubble-cli seal has written (*.rubblecase).", {}});
    }
    m_zip = unzOpen64(path.c_str());
    if (m_zip == nullptr) {
        throw ParseError(
            Message{"io.seal.cut_short", "{0} was cut short or damaged: the directory at its end is missing", {path}},
            Message{"io.seal.damaged.remedy", "Get the bundle anew from whoever sealed it, or from another copy.", {}});
    }
    try {
        listEntries();
    } catch (...) {
        unzClose(m_zip);
        throw;
    }
}

ZipReader::~ZipReader() {
    unzClose(m_zip);
}

void ZipReader::listEntries() {
    std::ifstream file(m_path, std::ios::binary);
    int state = unzGoToFirstFile(m_zip);
    while (state == UNZ_OK) {
        unz_file_info64 about{};
        unz64_file_pos place{};
        if (unzGetCurrentFileInfo64(m_zip, &about, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK ||
            unzGetFilePos64(m_zip, &place) != UNZ_OK) {
            failDamaged(m_path, "the directory");
        }
        std::string name(about.size_filename, '\0');
        std::vector<char> ended(name.size() + 1);
        unzGetCurrentFileInfo64(m_zip, &about, ended.data(), static_cast<uLong>(ended.size()), nullptr, 0, nullptr, 0);
        name.assign(ended.data(), name.size());
        if (!name.ends_with('/')) {
            const std::optional<DirectoryRecord> record = recordAt(file, place.pos_in_zip_directory);
            m_entries.push_back(
                {name, record ? record->bytes : about.uncompressed_size, place.pos_in_zip_directory, place.num_of_file});
        }
        state = unzGoToNextFile(m_zip);
    }
    if (state != UNZ_END_OF_LIST_OF_FILE) {
        failDamaged(m_path, "the directory");
    }
}

void ZipReader::read(const Entry& entry, const std::function<void(const char*, std::size_t)>& take) {
    const unz64_file_pos place{entry.place, entry.index};
    if (unzGoToFilePos64(m_zip, &place) != UNZ_OK) {
        failDamaged(m_path, entry.name);
    }
    unz_file_info64 about{};
    unzGetCurrentFileInfo64(m_zip, &about, nullptr, 0, nullptr, 0, nullptr, 0);
    if (about.compression_method == 0) {
        readStored(entry, take);
        return;
    }
    if (unzOpenCurrentFile(m_zip) != UNZ_OK) {
        failDamaged(m_path, entry.name);
    }
    std::vector<char> block(std::clamp<std::uint64_t>(entry.bytes, 1, std::uint64_t{1} << 18));
    std::uint64_t total = 0;
    try {
        for (;;) {
            const int got = unzReadCurrentFile(m_zip, block.data(), static_cast<unsigned>(block.size()));
            if (got < 0) {
                failDamaged(m_path, entry.name);
            }
            if (got == 0) {
                break;
            }
            total += static_cast<std::uint64_t>(got);
            if (total > entry.bytes) {
                failDamaged(m_path, entry.name);
            }
            take(block.data(), static_cast<std::size_t>(got));
        }
    } catch (...) {
        unzCloseCurrentFile(m_zip);
        throw;
    }
    if (unzCloseCurrentFile(m_zip) != UNZ_OK || total != entry.bytes) {
        failDamaged(m_path, entry.name);
    }
}

void ZipReader::readStored(const Entry& entry, const std::function<void(const char*, std::size_t)>& take) {
    unz_file_info64 about{};
    unzGetCurrentFileInfo64(m_zip, &about, nullptr, 0, nullptr, 0, nullptr, 0);
    constexpr std::size_t headBytes = 30;
    std::array<char, headBytes> head{};
    std::ifstream file(m_path, std::ios::binary);
    const std::optional<DirectoryRecord> found = recordAt(file, entry.place);
    const std::uint64_t place = found ? found->place : 0;
    file.clear();
    file.seekg(static_cast<std::streamoff>(place));
    file.read(head.data(), head.size());
    const bool stored = found && littleEndian(&head[8], 2) == 0 && found->packed == entry.bytes;
    if (!file || std::memcmp(head.data(), "PK\3\4", 4) != 0 || !stored) {
        failDamaged(m_path, entry.name);
    }
    file.seekg(static_cast<std::streamoff>(place + headBytes + littleEndian(&head[26], 2) + littleEndian(&head[28], 2)));
    std::vector<char> block(std::clamp<std::uint64_t>(entry.bytes, 1, std::uint64_t{1} << 18));
    uLong check = crc32(0, nullptr, 0);
    for (std::uint64_t left = entry.bytes; left > 0;) {
        const std::size_t size = static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size()));
        if (!file.read(block.data(), static_cast<std::streamsize>(size))) {
            failDamaged(m_path, entry.name);
        }
        check = crc32(check, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(size));
        take(block.data(), size);
        left -= size;
    }
    if (check != about.crc) {
        failDamaged(m_path, entry.name);
    }
}

std::string ZipReader::content(const Entry& entry) {
    if (entry.bytes > contentMost) {
        failDamaged(m_path, entry.name);
    }
    std::string text;
    read(entry, [&](const char* data, std::size_t size) { text.append(data, size); });
    return text;
}

/// A file that keeps what is written beside the contents.
struct ZipLayout::Ghost {
    std::uint64_t at = 0;
    std::uint64_t size = 0;
    std::uint64_t contentFrom = 0, contentTo = 0;
    std::map<std::uint64_t, std::string> parts;  ///< by the place of their first byte

    void write(const char* data, std::uint64_t count) {
        if (at < contentFrom || at >= contentTo) {
            put(data, count);
        }
        at += count;
        size = std::max(size, at);
    }

    // A head is written before its content and mended after it, within itself.
    void put(const char* data, std::uint64_t count) {
        auto part = parts.upper_bound(at);
        if (part != parts.begin() && at <= std::prev(part)->first + std::prev(part)->second.size()) {
            --part;
            part->second.replace(at - part->first, count, data, count);
        } else {
            parts[at].assign(data, count);
        }
    }

    long seek(std::uint64_t offset, int origin) {
        if (origin == ZLIB_FILEFUNC_SEEK_SET) {
            at = offset;
        } else if (origin == ZLIB_FILEFUNC_SEEK_CUR) {
            at += offset;
        } else {
            at = size + offset;
        }
        return 0;
    }
};

ZipLayout::ZipLayout() : m_ghost(new Ghost) {
    zlib_filefunc64_def functions{};
    functions.opaque = m_ghost;
    functions.zopen64_file = [](voidpf ghost, const void*, int) { return ghost; };
    functions.zread_file = [](voidpf, voidpf, void*, uLong) { return uLong{0}; };
    functions.zwrite_file = [](voidpf ghost, voidpf, const void* data, uLong count) {
        static_cast<Ghost*>(ghost)->write(static_cast<const char*>(data), count);
        return count;
    };
    functions.ztell64_file = [](voidpf ghost, voidpf) { return static_cast<ZPOS64_T>(static_cast<Ghost*>(ghost)->at); };
    functions.zseek64_file = [](voidpf ghost, voidpf, ZPOS64_T offset, int origin) {
        return static_cast<Ghost*>(ghost)->seek(offset, origin);
    };
    functions.zclose_file = [](voidpf, voidpf) { return 0; };
    functions.zerror_file = [](voidpf, voidpf) { return 0; };
    m_zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
}

ZipLayout::~ZipLayout() {
    if (m_zip != nullptr) {
        zipClose(m_zip, nullptr);
    }
    delete m_ghost;
}

void ZipLayout::open(const std::string& name, std::uint64_t bytes) {
    m_ghost->contentFrom = m_ghost->contentTo = 0;
    openEntry(m_zip, name, bytes);
    m_ghost->contentFrom = m_ghost->at;
    m_ghost->contentTo = m_ghost->at + bytes;
}

void ZipLayout::write(const char* data, std::size_t size) {
    writeEntry(m_zip, data, size);
}

void ZipLayout::close() {
    zipCloseFileInZip(m_zip);
}

std::optional<std::uint64_t> ZipLayout::firstDifference(const std::string& path) {
    m_ghost->contentFrom = m_ghost->contentTo = 0;
    zipClose(m_zip, nullptr);
    m_zip = nullptr;
    std::ifstream file(path, std::ios::binary);
    for (const auto& [place, written] : m_ghost->parts) {
        std::string found(written.size(), '\0');
        file.clear();
        file.seekg(static_cast<std::streamoff>(place));
        file.read(found.data(), static_cast<std::streamsize>(found.size()));
        found.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
        const auto [ours, theirs] = std::mismatch(written.begin(), written.end(), found.begin(), found.end());
        if (ours != written.end()) {
            return place + static_cast<std::uint64_t>(ours - written.begin());
        }
    }
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    if (size != m_ghost->size) {
        return std::min(size, m_ghost->size);
    }
    return {};
}

}  // namespace rubble::io
