#include "io/site/clouds/e57/e57_columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

/// Bytes that are loaded beyond the last value, so that eight can be taken at any place.
constexpr std::size_t paddingBytes = 9;

[[noreturn]] void refusePackets(const E57Pages& pages, std::uint64_t at) {
    refuseContent({"cloud.e57_packet",
                   "{0} is damaged: no packet of points can be read at byte {1} of its content",
                   {pages.path(), static_cast<std::int64_t>(at)}},
                  "Copy it again from where it came, or export the scans anew.");
}

}  // namespace

void E57Column::add(const unsigned char* bytes, std::size_t count) {
    if (!m_kept) {
        m_counted += count;
        return;
    }
    if (const auto whole = static_cast<std::size_t>(m_bit / 8); whole > 0) {
        m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(std::min(whole, m_bytes.size())));
        m_bit %= 8;
    }
    m_bytes.insert(m_bytes.end(), bytes, bytes + count);
}

std::uint64_t E57Column::ready() const {
    if (m_field.bits == 0) {
        return std::numeric_limits<std::uint64_t>::max();
    }
    return (8 * (m_bytes.size() + m_counted) - m_bit) / m_field.bits;
}

std::uint64_t E57Column::bitsAt(std::uint64_t bit) const {
    std::array<unsigned char, paddingBytes> near{};
    const auto at = static_cast<std::size_t>(bit / 8);
    const unsigned char* from = &m_bytes[at];
    if (at + paddingBytes > m_bytes.size()) {
        std::copy(m_bytes.begin() + static_cast<std::ptrdiff_t>(at), m_bytes.end(), near.begin());
        from = near.data();
    }
    const std::uint64_t shift = bit % 8;
    std::uint64_t value = littleAt<std::uint64_t>(from) >> shift;
    if (shift > 0) {
        value |= std::uint64_t{from[8]} << (64 - shift);
    }
    return m_field.bits < 64 ? value & ((std::uint64_t{1} << m_field.bits) - 1) : value;
}

void E57Column::take(std::size_t count, std::vector<double>& values) {
    values.resize(m_kept ? count : 0);
    m_bit += m_kept ? 0 : count * std::uint64_t{m_field.bits};
    for (double& value : values) {
        const std::uint64_t raw = m_field.bits > 0 ? bitsAt(m_bit) : 0;
        m_bit += m_field.bits;
        if (m_field.kind == E57Field::Kind::Single) {
            value = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
        } else if (m_field.kind == E57Field::Kind::Double) {
            value = std::bit_cast<double>(raw);
        } else {
            const auto whole = static_cast<std::int64_t>(raw + static_cast<std::uint64_t>(m_field.least));
            value = static_cast<double>(whole) * m_field.scale + m_field.offset;
        }
    }
}

E57Columns::E57Columns(E57Pages& pages, const E57Points& points, const std::vector<bool>& kept) : m_pages(pages) {
    for (std::size_t f = 0; f < points.fields.size(); ++f) {
        m_columns.emplace_back(points.fields[f], kept[f]);
    }
    std::array<unsigned char, 32> head{};
    m_pages.read(points.start, head.data(), head.size());
    constexpr unsigned char pointSection = 1;
    const auto bytes = littleAt<std::uint64_t>(&head[8]);
    m_at = m_pages.placeOf(littleAt<std::uint64_t>(&head[16]));
    m_end = std::min(m_pages.size(), points.start + std::min(bytes, m_pages.size()));
    if (head[0] != pointSection) {
        refusePackets(m_pages, points.start);
    }
}

std::uint64_t E57Columns::ready() const {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (const E57Column& column : m_columns) {
        least = std::min(least, column.ready());
    }
    return least;
}

std::uint64_t E57Columns::fill(std::uint64_t wanted) {
    std::uint64_t there = ready();
    while (there < wanted && m_at < m_end) {
        readPacket();
        there = ready();
    }
    return std::min(there, wanted);
}

void E57Columns::readPacket() {
    constexpr std::uint64_t shortest = 4;
    if (m_end - m_at < shortest) {
        m_at = m_end;
        return;
    }
    std::array<unsigned char, shortest> head{};
    m_pages.read(m_at, head.data(), head.size());
    const std::uint64_t bytes = std::uint64_t{littleAt<std::uint16_t>(&head[2])} + 1;
    if (head[0] > 2 || bytes < shortest || bytes > m_end - m_at) {
        refusePackets(m_pages, m_at);
    }
    if (head[0] == 1) {
        takeData(m_pages.bytes(m_at, bytes));
    }
    m_at += bytes;
}

void E57Columns::takeData(const std::vector<unsigned char>& packet) {
    constexpr std::size_t head = 6;
    /// No writer lets one column run so far ahead of the others.
    constexpr std::size_t bufferedMost = std::size_t{1} << 26;
    const std::size_t streams = packet.size() < head ? 0 : littleAt<std::uint16_t>(&packet[4]);
    std::size_t at = head + 2 * streams;
    if (streams != m_columns.size() || at > packet.size()) {
        refusePackets(m_pages, m_at);
    }
    for (std::size_t s = 0; s < streams; ++s) {
        const std::size_t bytes = littleAt<std::uint16_t>(&packet[head + 2 * s]);
        if (bytes > packet.size() - at || m_columns[s].buffered() + bytes > bufferedMost) {
            refusePackets(m_pages, m_at);
        }
        m_columns[s].add(&packet[at], bytes);
        at += bytes;
    }
}

}  // namespace rubble::io
