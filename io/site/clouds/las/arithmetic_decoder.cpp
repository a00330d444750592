#include "io/site/clouds/las/arithmetic_decoder.h"

#include <algorithm>

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
    m_symbols = symbols;
    m_from.assign(symbols, 0);
    m_count.assign(symbols, 1);
    m_tableShift = 0;
    if (symbols > 16) {
        std::uint32_t tableBits = 3;
        while (symbols > std::uint32_t{1} << (tableBits + 2)) {
            ++tableBits;
        }
        m_tableShift = symbolShares - tableBits;
        m_table.assign((std::size_t{1} << tableBits) + 2, 0);
    }
    m_total = 0;
    m_cycle = symbols;
    learn();
    m_cycle = m_left = (symbols + 6) / 2;
}

void SymbolModel::learn() {
    m_total += m_cycle;
    if (m_total > std::uint32_t{1} << symbolShares) {
        m_total = 0;
        for (std::uint32_t& count : m_count) {
            count = (count + 1) / 2;
            m_total += count;
        }
    }
    const std::uint32_t scale = (std::uint32_t{1} << wholeShift) / m_total;
    std::uint32_t sum = 0;
    std::size_t parts = 0;
    for (std::uint32_t s = 0; s < m_symbols; ++s) {
        m_from[s] = (scale * sum) >> (wholeShift - symbolShares);
        sum += m_count[s];
        if (m_tableShift > 0) {
            for (const std::size_t part = m_from[s] >> m_tableShift; parts < part;) {
                m_table[++parts] = s - 1;
            }
        }
    }
    if (m_tableShift > 0) {
        m_table[0] = 0;
        std::fill(m_table.begin() + static_cast<std::ptrdiff_t>(parts) + 1, m_table.end(), m_symbols - 1);
    }
    m_cycle = std::min(5 * m_cycle / 4, (m_symbols + 6) * 8);
    m_left = m_cycle;
}

void ArithmeticDecoder::start() {
    m_length = 0xffffffff;
    m_value = 0;
    for (int i = 0; i < 4; ++i) {
        m_value = m_value << 8 | m_bytes.next();
    }
    // No coder writes a value outside its range; the models rely on it.
    m_value = std::min(m_value, m_length - 1);
}

}  // namespace rubble::io
