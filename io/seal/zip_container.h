#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::io {

/// Most entries of a container: minizip counts no further.
inline constexpr std::size_t zipEntriesMost = 65534;

/// Files in one zip container (zip64 where it must be), each stored byte for byte: nothing in it depends on the version of a packer
/// or on a clock, so that equal files make equal containers. Written by minizip, which is small, kept with zlib, and comes with
/// GDAL's packages anyway.
class ZipWriter {
public:
    /// Writes a file. Throws WorldError.
    explicit ZipWriter(const std::string& path);
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// Begins an entry. Throws UsageError beyond zipEntriesMost. @param bytes  that will be written to it
    void open(const std::string& name, std::uint64_t bytes);
    void write(const char* data, std::size_t size);
    void close();
    void add(const std::string& name, std::string_view content);
    /// Writes the directory of the container. Throws WorldError.
    void finish();

private:
    std::string m_path;
    void* m_zip;
    std::size_t m_entries = 0;
};

/// Reads a zip container of whatever program.
class ZipReader {
public:
    struct Entry {
        std::string name;
        std::uint64_t bytes = 0;  ///< not packed
        std::uint64_t place = 0;  ///< in the directory
        std::uint64_t index = 0;
    };

    /// Throws WorldError (cannot be read), ParseError (no container, or cut short).
    explicit ZipReader(const std::string& path);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    const std::string& path() const { return m_path; }
    /// In the order of the directory. Folders are left out.
    const std::vector<Entry>& entries() const { return m_entries; }
    /// Reads an entry block by block. Throws ParseError naming it if it is damaged, and what `take` throws.
    void read(const Entry& entry, const std::function<void(const char*, std::size_t)>& take);
    /// A whole entry. Throws ParseError if it is damaged or longer than 64 MiB.
    std::string content(const Entry& entry);

private:
    void listEntries();
    void readStored(const Entry& entry, const std::function<void(const char*, std::size_t)>& take);

    std::string m_path;
    void* m_zip;
    std::vector<Entry> m_entries;
};

/// Packs what is read from a container once more, in memory and without the contents, to tell whether the container itself is as
/// ZipWriter writes it: each byte of it, names, dates and rights too.
class ZipLayout {
public:
    ZipLayout();
    ~ZipLayout();
    ZipLayout(const ZipLayout&) = delete;
    ZipLayout& operator=(const ZipLayout&) = delete;

    void open(const std::string& name, std::uint64_t bytes);
    void write(const char* data, std::size_t size);
    void close();
    /// The first byte of the file that is not as it would be written, from 0; nothing if there is none. Throws WorldError.
    std::optional<std::uint64_t> firstDifference(const std::string& path);

private:
    struct Ghost;
    Ghost* m_ghost;
    void* m_zip;
};

}  // namespace rubble::io
