#pragma once

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

    std::uint32_t m_symbols = 0;
    std::uint32_t m_total = 0;
    std::uint32_t m_cycle = 0;
    std::uint32_t m_left = 0;            ///< symbols until the shares are renewed
    std::uint32_t m_tableShift = 0;      ///< 0: too few symbols for a table
    std::vector<std::uint32_t> m_from;   ///< [symbols] sum of the shares before each, of 32,768
    std::vector<std::uint32_t> m_count;  ///< [symbols]
    std::vector<std::uint32_t> m_table;  ///< the last symbol that begins at or before each part of the shares
};

/// The arithmetic decoder of LASzip: an adaptive range coder of 32 bits that takes whole bytes, as Said described it (2004).
/// Any bytes give symbols of their models, so damage shows in the points and at the end of the bytes only.
class ArithmeticDecoder {
public:
    explicit ArithmeticDecoder(PackedBytes& bytes) : m_bytes(bytes) {}

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
        const std::uint32_t* from = model.m_from.data();
        const std::uint32_t unit = m_length >> 15;
        std::uint32_t found = 0;
        std::uint32_t beyond = model.m_symbols;
        if (model.m_tableShift > 0) {
            const std::uint32_t share = m_value / unit;
            const std::uint32_t part = share >> model.m_tableShift;
            found = model.m_table[part];
            beyond = model.m_table[part + 1] + 1;
            while (beyond > found + 1) {
                const std::uint32_t middle = (found + beyond) >> 1;
                (from[middle] > share ? beyond : found) = middle;
            }
        } else {
            while (beyond > found + 1) {
                const std::uint32_t middle = (found + beyond) >> 1;
                (unit * from[middle] > m_value ? beyond : found) = middle;
            }
        }
        const std::uint32_t low = from[found] * unit;
        const std::uint32_t high = found + 1 == model.m_symbols ? m_length : from[found + 1] * unit;
        m_value -= low;
        m_length = high - low;
        widen();
        ++model.m_count[found];
        if (--model.m_left == 0) {
            model.learn();
        }
        return found;
    }

    /// A number of so many bits that no model knows, at most 32.
    std::uint32_t bits(std::uint32_t count) {
        if (count > 19) {
            const std::uint32_t low = few(16);
            return low | bits(count - 16) << 16;
        }
        return few(count);
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
    void widen() {
        while (m_length < (std::uint32_t{1} << 24)) {
            m_value = m_value << 8 | m_bytes.next();
            m_length <<= 8;
        }
    }

    PackedBytes& m_bytes;
    std::uint32_t m_value = 0;
    std::uint32_t m_length = 0;
};

}  // namespace rubble::io
