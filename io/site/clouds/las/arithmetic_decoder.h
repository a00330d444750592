#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "io/site/clouds/las/packed_bytes.h"

namespace rubble::io {

/// How likely a bit is 0, learned from those that came.
class BitModel {
public:
    void start();

private:
    friend class ArithmeticDecoder;
    void learn();

    std::uint32_t m_zeroShare = 0;  ///< of 8,192
    std::uint32_t m_zeros = 0;
    std::uint32_t m_bits = 0;
    std::uint32_t m_cycle = 0;
    std::uint32_t m_left = 0;  ///< bits until the share is renewed
};

/// How likely each of some symbols is, learned from those that came.
class SymbolModel {
public:
    /// All are equally likely.
    void start(std::uint32_t symbols);
    bool started() const { return m_symbols > 0; }
    /// Forgets what was learned; it must be started again.
    void stop() { m_symbols = 0; }

private:
    friend class ArithmeticDecoder;
    void learn();

    static constexpr std::uint32_t wholeShare = std::uint32_t{1} << 15;
    struct Entry {
        std::uint16_t from = 0;  ///< sum of the shares before this symbol, of 32,768; beyond all behind the last one
        std::uint16_t count = 0;
    };
    std::uint32_t m_symbols = 0;
    std::uint32_t m_total = 0;
    std::uint32_t m_cycle = 0;
    std::uint32_t m_left = 0;  ///< symbols until the shares are renewed
    std::uint32_t m_tableShift = 0;
    std::vector<Entry> m_entries;        ///< [symbols + 1]
    std::vector<std::uint16_t> m_table;  ///< the last symbol that begins at or before each part of the shares
};

/// The arithmetic decoder of LASzip: an adaptive range coder of 32 bits that takes whole bytes, as Said described it (2004).
/// Any bytes give symbols of their models, so damage shows in the points and at the end of the bytes only.
class ArithmeticDecoder {
public:
    explicit ArithmeticDecoder(PackedBytes& bytes) : m_bytes(&bytes) {}

    /// Takes the first four bytes.
    void start();

    std::uint32_t bit(BitModel& model) {
        const std::uint32_t parted = model.m_zeroShare * (m_length >> 13);
        // By masks, as no processor foretells bits. What is below the parted share is a 0.
        const auto zero = static_cast<std::uint32_t>((std::uint64_t{m_value} - parted) >> 32);
        m_value -= parted & ~zero;
        m_length = parted + ((m_length - 2 * parted) & ~zero);
        model.m_zeros -= zero;
        widen();
        if (--model.m_left == 0) [[unlikely]] {
            model.learn();
        }
        return 1 + zero;
    }

    std::uint32_t symbol(SymbolModel& model) {
        const std::uint32_t unit = m_length >> 15;
        const std::uint32_t share = m_value / unit;
        SymbolModel::Entry* const entries = model.m_entries.data();
        SymbolModel::Entry* at = entries + model.m_table[share >> model.m_tableShift];
        while (at[1].from <= share) {
            ++at;
        }
        const std::uint32_t low = at[0].from * unit;
        // What is above the last symbol is its as well. The product is made in any case: a compiler that leaves it out makes a
        // branch, and no processor foretells which symbol it is.
        const std::uint32_t next = at[1].from;
        std::uint32_t high = next * unit;
        asm("" : "+r"(high));
        high = next > SymbolModel::wholeShare ? m_length : high;
        m_value -= low;
        m_length = high - low;
        ++at->count;
        const auto found = static_cast<std::uint32_t>(at - entries);
        --model.m_left;
        if (model.m_left != 0 && m_bytes->holdsFour()) [[likely]] {
            widenQuickly();
            return found;
        }
        return finishSlowly(model, found);
    }

    /// A number of so many bits that no model knows, at most 32.
    std::uint32_t bits(std::uint32_t count) {
        if (count <= 19) {
            return few(count);
        }
        const std::uint32_t low = few(16);
        return low | few(count - 16) << 16;
    }
    std::uint64_t longBits() {
        const std::uint64_t low = bits(32);
        return low | std::uint64_t{bits(32)} << 32;
    }

private:
    std::uint32_t few(std::uint32_t count) {
        m_length >>= count;
        const std::uint32_t number = m_value / m_length;
        m_value -= number * m_length;
        widen();
        return number;
    }
    /// Takes bytes until the range is wider than 24 bits.
    void widen() { m_bytes->holdsFour() ? widenQuickly() : widenSlowly(); }
    void widenQuickly() {
        const std::uint32_t bits = static_cast<std::uint32_t>(std::countl_zero(m_length | 1U)) & 24U;
        const std::uint64_t ahead = (std::uint64_t{m_value} << 32 | m_bytes->ahead()) << bits;
        m_value = static_cast<std::uint32_t>(ahead >> 32);
        m_length <<= bits;
        m_bytes->skip(bits / 8);
    }
    void widenSlowly();
    /// What a symbol seldom needs, kept out of the way of the others. @return found
    std::uint32_t finishSlowly(SymbolModel& model, std::uint32_t found);

    PackedBytes* m_bytes;
    std::uint32_t m_value = 0;
    std::uint32_t m_length = 0xffffffff;
};

}  // namespace rubble::io
