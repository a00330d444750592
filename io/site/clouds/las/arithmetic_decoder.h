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

    std::uint16_t* shares() { return m_numbers.data(); }
    std::uint16_t* counts() { return m_numbers.data() + m_symbols + 1; }
    std::uint16_t* table() { return m_numbers.data() + 2 * std::size_t{m_symbols} + 1; }

    std::uint32_t m_symbols = 0;
    std::uint32_t m_total = 0;
    std::uint32_t m_cycle = 0;
    std::uint32_t m_left = 0;  ///< symbols until the shares are renewed
    std::uint32_t m_tableShift = 0;
    /// Sums of the shares before each symbol, of 32,768, and one beyond all [symbols + 1]; how often each came [symbols]; the
    /// last symbol that begins at or before each part of the shares.
    std::vector<std::uint16_t> m_numbers;
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
        const bool one = m_value >= parted;
        if (one) {
            m_value -= parted;
            m_length -= parted;
        } else {
            m_length = parted;
            ++model.m_zeros;
        }
        widen();
        if (--model.m_left == 0) {
            model.learn();
        }
        return one ? 1 : 0;
    }

    std::uint32_t symbol(SymbolModel& model) {
        const std::uint16_t* from = model.shares();
        const std::uint32_t unit = m_length >> 15;
        const std::uint32_t share = m_value / unit;
        std::uint32_t found = model.table()[share >> model.m_tableShift];
        while (from[found + 1] <= share) {
            ++found;
        }
        const std::uint32_t low = from[found] * unit;
        // What is above the last symbol is its as well. By a mask: no processor foretells which symbol it is.
        const std::uint32_t last = 0U - static_cast<std::uint32_t>(found + 1 == model.m_symbols);
        const std::uint32_t high = from[found + 1] * unit;
        m_value -= low;
        m_length = (high ^ ((high ^ m_length) & last)) - low;
        widen();
        ++model.counts()[found];
        if (--model.m_left == 0) {
            model.learn();
        }
        return found;
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
    void widen() {
        const auto bytes = static_cast<std::uint32_t>(std::countl_zero(m_length | 1U)) / 8;
        if (m_bytes->holdsFour()) [[likely]] {
            const std::uint64_t next = std::uint64_t{m_bytes->ahead()} << 8 * bytes;
            m_value = m_value << 8 * bytes | static_cast<std::uint32_t>(next >> 32);
            m_length <<= 8 * bytes;
            m_bytes->skip(bytes);
            return;
        }
        for (std::uint32_t b = 0; b < bytes; ++b) {
            m_value = m_value << 8 | m_bytes->next();
            m_length <<= 8;
        }
    }

    PackedBytes* m_bytes;
    std::uint32_t m_value = 0;
    std::uint32_t m_length = 0xffffffff;
};

}  // namespace rubble::io
