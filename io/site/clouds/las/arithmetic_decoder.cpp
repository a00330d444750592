#include "io/site/clouds/las/arithmetic_decoder.h"

#include <algorithm>
#include <limits>

namespace rubble::io {

namespace {

/// One whole in the sums of shares.
constexpr std::uint32_t wholeShift = 31;
constexpr std::uint32_t symbolShares = 15;
constexpr std::uint32_t bitShares = 13;

}  // namespace

void BitModel::start() {
    m_zeros = 1;
    m_bits = 2;
    m_zeroShare = std::uint32_t{1} << (bitShares - 1);
    m_cycle = m_left = 4;
}

void BitModel::learn() {
    m_bits += m_cycle;
    if (m_bits > std::uint32_t{1} << bitShares) {
        m_bits = (m_bits + 1) / 2;
        m_zeros = (m_zeros + 1) / 2;
        m_bits += m_zeros == m_bits ? 1 : 0;
    }
    const std::uint32_t scale = (std::uint32_t{1} << wholeShift) / m_bits;
    m_zeroShare = (m_zeros * scale) >> (wholeShift - bitShares);
    m_cycle = std::min<std::uint32_t>(5 * m_cycle / 4, 64);
    m_left = m_cycle;
}

void SymbolModel::start(std::uint32_t symbols) {
    // Finer tables find a symbol sooner and take longer to renew.
    const std::uint32_t tableBits = symbols > 64 ? 8 : symbols > 16 ? 7 : 5;
    m_tableShift = symbolShares - tableBits;
    m_symbols = symbols;
    m_numbers.assign(2 * std::size_t{symbols} + 1 + (std::size_t{1} << tableBits) + 2, 0);
    std::fill_n(counts(), symbols, std::uint16_t{1});
    shares()[symbols] = std::numeric_limits<std::uint16_t>::max();
    m_total = 0;
    m_cycle = symbols;
    learn();
    m_cycle = m_left = (symbols + 6) / 2;
}

void SymbolModel::learn() {
    std::uint16_t* from = shares();
    std::uint16_t* count = counts();
    m_total += m_cycle;
    if (m_total > std::uint32_t{1} << symbolShares) {
        m_total = 0;
        for (std::uint32_t s = 0; s < m_symbols; ++s) {
            count[s] = static_cast<std::uint16_t>((count[s] + 1) / 2);
            m_total += count[s];
        }
    }
    const std::uint32_t scale = (std::uint32_t{1} << wholeShift) / m_total;
    std::uint32_t sum = 0;
    std::uint16_t* parts = table();
    std::uint16_t* const end = m_numbers.data() + m_numbers.size();
    std::fill(parts, end, std::uint16_t{0});
    const std::uint32_t beforeNext = (std::uint32_t{1} << m_tableShift) - 1;
    for (std::uint32_t s = 0; s < m_symbols; ++s) {
        from[s] = static_cast<std::uint16_t>((scale * sum) >> (wholeShift - symbolShares));
        sum += count[s];
        // The last symbol that begins in a part or at its beginning counts for the parts that follow.
        parts[(from[s] + beforeNext) >> m_tableShift] = static_cast<std::uint16_t>(s);
    }
    std::uint16_t latest = 0;
    for (; parts < end; ++parts) {
        latest = std::max(latest, *parts);
        *parts = latest;
    }
    m_cycle = std::min(5 * m_cycle / 4, (m_symbols + 6) * 8);
    m_left = m_cycle;
}

void ArithmeticDecoder::start() {
    m_length = 0xffffffff;
    m_value = 0;
    for (int i = 0; i < 4; ++i) {
        m_value = m_value << 8 | m_bytes->next();
    }
    // No coder writes a value outside its range; the models rely on it.
    m_value = std::min(m_value, m_length - 1);
}

}  // namespace rubble::io
