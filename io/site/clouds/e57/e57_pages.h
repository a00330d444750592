#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

/// The content of an E57, whose pages end in a checksum each. Places in it are of the content unless they are called of the file.
class E57Pages {
public:
    /// Throws WorldError, ParseError (no E57 1.x, pages of no size).
    explicit E57Pages(const std::string& path);

    const std::string& path() const { return m_file.path(); }
    std::uint64_t size() const { return m_pages * (m_page - checksumBytes); }
    std::uint64_t placeOf(std::uint64_t placeInFile) const;
    /// Throws ParseError where the content ends before, or a page does not fit its checksum.
    void read(std::uint64_t at, unsigned char* target, std::size_t count);
    std::vector<unsigned char> bytes(std::uint64_t at, std::uint64_t count);
    [[noreturn]] void failCut() const { m_file.failCut(); }

    std::uint64_t xmlStart() const { return placeOf(m_xmlPlace); }
    std::uint64_t xmlBytes() const { return m_xmlBytes; }
    const std::string& version() const { return m_version; }

private:
    static constexpr std::uint64_t checksumBytes = 4;
    void load(std::uint64_t page);

    CloudFile m_file;
    std::string m_version;
    std::uint64_t m_page = 0;   ///< bytes
    std::uint64_t m_pages = 0;  ///< whole ones
    std::uint64_t m_xmlPlace = 0;
    std::uint64_t m_xmlBytes = 0;
    std::vector<unsigned char> m_loaded;  ///< pages from m_first on, checked
    std::uint64_t m_first = 0;
    std::uint64_t m_count = 0;
};

/// CRC-32C of Castagnoli.
std::uint32_t crc32c(const unsigned char* bytes, std::size_t count);

}  // namespace rubble::io
