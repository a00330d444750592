#include "io/site/clouds/las/arithmetic_decoder.h"

#include <algorithm>
#include <cassert>
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
    m_entries.assign(std::size_t{symbols} + 1, {0, 1});
    m_entries.back().from = std::numeric_limits<std::uint16_t>::max();
    m_table.assign((std::size_t{1} << tableBits) + 2, 0);
    m_total = 0;
    m_cycle = symbols;
    learn();
    m_cycle = m_left = (symbols + 6) / 2;
}

void SymbolModel::learn() {
    m_total += m_cycle;
    if (m_total > wholeShare) {
        m_total = 0;
        for (std::uint32_t s = 0; s < m_symbols; ++s) {
            m_entries[s].count = static_cast<std::uint16_t>((m_entries[s].count + 1) / 2);
            m_total += m_entries[s].count;
        }
    }
    assert(m_total > 0);  // each symbol counts at least one
    const std::uint32_t scale = (std::uint32_t{1} << wholeShift) / m_total;
    std::uint32_t sum = 0;
    std::fill(m_table.begin(), m_table.end(), std::uint16_t{0});
    const std::uint32_t beforeNext = (std::uint32_t{1} << m_tableShift) - 1;
    for (std::uint32_t s = 0; s < m_symbols; ++s) {
        Entry& entry = m_entries[s];
        entry.from = static_cast<std::uint16_t>((scale * sum) >> (wholeShift - symbolShares));
        sum += entry.count;
        // The last symbol that begins in a part or at its beginning counts for the parts that follow.
        m_table[(entry.from + beforeNext) >> m_tableShift] = static_cast<std::uint16_t>(s);
    }
    std::uint16_t latest = 0;
    for (std::uint16_t& part : m_table) {
        latest = std::max(latest, part);
        part = latest;
    }
    m_cycle = std::min(5 * m_cycle / 4, (m_symbols + 6) * 8);
    m_left = m_cycle;
}

void ArithmeticDecoder::widenSlowly() {
    const int bytes = std::countl_zero(m_length | 1U) / 8;
    for (int b = 0; b < bytes; ++b) {
        m_value = m_value << 8 | m_bytes->next();
        m_length <<= 8;
    }
}

std::uint32_t ArithmeticDecoder::finishSlowly(SymbolModel& model, std::uint32_t found) {
    if (model.m_left == 0) {
        model.learn();
    }
    widen();
    return found;
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
