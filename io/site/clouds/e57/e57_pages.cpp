#include "io/site/clouds/e57/e57_pages.h"

#include <algorithm>
#include <array>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

constexpr std::size_t crcSlices = 8;

/// What each byte does to a checksum, from 0 to 7 bytes before the end of eight.
std::array<std::array<std::uint32_t, 256>, crcSlices> crcTables() {
    constexpr std::uint32_t castagnoli = 0x82f63b78;  // mirrored
    std::array<std::array<std::uint32_t, 256>, crcSlices> tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? castagnoli : 0);
        }
        tables[0][byte] = crc;
    }
    for (std::size_t slice = 1; slice < crcSlices; ++slice) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[slice - 1][byte];
            tables[slice][byte] = (before >> 8) ^ tables[0][before & 0xff];
        }
    }
    return tables;
}

}  // namespace

std::uint32_t crc32c(const unsigned char* bytes, std::size_t count) {
    static const std::array<std::array<std::uint32_t, 256>, crcSlices> tables = crcTables();
    std::uint32_t crc = ~std::uint32_t{0};
    for (; count >= crcSlices; bytes += crcSlices, count -= crcSlices) {
        const std::uint64_t eight = littleAt<std::uint64_t>(bytes) ^ crc;
        crc = 0;
        for (std::size_t k = 0; k < crcSlices; ++k) {
            crc ^= tables[crcSlices - 1 - k][eight >> (8 * k) & 0xff];
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        crc = (crc >> 8) ^ tables[0][(crc ^ bytes[k]) & 0xff];
    }
    return ~crc;
}

E57Pages::E57Pages(const std::string& path) : m_file(path) {
    std::array<unsigned char, 48> head{};
    m_file.read(0, head.data(), head.size());
    const auto major = littleAt<std::uint32_t>(&head[8]);
    m_version = std::to_string(major) + "." + std::to_string(littleAt<std::uint32_t>(&head[12]));
    m_xmlPlace = littleAt<std::uint64_t>(&head[24]);
    m_xmlBytes = littleAt<std::uint64_t>(&head[32]);
    m_page = littleAt<std::uint64_t>(&head[40]);
    constexpr std::uint64_t pageMost = std::uint64_t{1} << 20;
    if (major != 1 || m_page < 64 || m_page > pageMost) {
        refuseContent({"cloud.e57_head",
                       "{0} is E57 {1} with pages of {2} bytes, which cannot be read",
                       {path, m_version, static_cast<std::int64_t>(m_page)}},
                      "Write it anew as E57 1.0.");
    }
    m_pages = m_file.size() / m_page;
}

std::uint64_t E57Pages::placeOf(std::uint64_t placeInFile) const {
    return placeInFile / m_page * (m_page - checksumBytes) + std::min(placeInFile % m_page, m_page - checksumBytes);
}

void E57Pages::load(std::uint64_t page) {
    constexpr std::uint64_t bytesAtOnce = std::uint64_t{1} << 18;
    const std::uint64_t count = std::min(std::max<std::uint64_t>(bytesAtOnce / m_page, 1), m_pages - page);
    m_count = 0;
    m_loaded.resize(static_cast<std::size_t>(count * m_page));
    m_file.read(page * m_page, m_loaded.data(), m_loaded.size());
    const auto content = static_cast<std::size_t>(m_page - checksumBytes);
    for (std::uint64_t p = 0; p < count; ++p) {
        const unsigned char* bytes = &m_loaded[static_cast<std::size_t>(p * m_page)];
        const unsigned char* sum = bytes + content;
        const std::uint32_t stated =
            std::uint32_t{sum[0]} << 24 | std::uint32_t{sum[1]} << 16 | std::uint32_t{sum[2]} << 8 | sum[3];
        if (crc32c(bytes, content) != stated) {
            refuseContent({"cloud.e57_checksum",
                           "{0} is damaged: page {1} of {2} does not fit its checksum",
                           {m_file.path(), static_cast<std::int64_t>(page + p + 1), static_cast<std::int64_t>(m_pages)}},
                          "Copy it again from where it came, or export the scans anew.");
        }
    }
    m_first = page;
    m_count = count;
}

void E57Pages::read(std::uint64_t at, unsigned char* target, std::size_t count) {
    const std::uint64_t content = m_page - checksumBytes;
    if (at > size() || count > size() - at) {
        failCut();
    }
    while (count > 0) {
        const std::uint64_t page = at / content;
        if (page < m_first || page >= m_first + m_count) {
            load(page);
        }
        const auto inPage = static_cast<std::size_t>(at % content);
        const std::size_t here = std::min(count, static_cast<std::size_t>(content) - inPage);
        std::copy_n(&m_loaded[static_cast<std::size_t>((page - m_first) * m_page) + inPage], here, target);
        at += here;
        target += here;
        count -= here;
    }
}

std::vector<unsigned char> E57Pages::bytes(std::uint64_t at, std::uint64_t count) {
    if (at > size() || count > size() - at) {
        failCut();
    }
    std::vector<unsigned char> all(static_cast<std::size_t>(count));
    read(at, all.data(), all.size());
    return all;
}

}  // namespace rubble::io
