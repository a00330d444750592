#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "io/site/clouds/las/integer_decoder.h"

namespace rubble::io {

/// The median of the last five numbers, kept while they come.
class RunningMedian {
public:
    std::int32_t median() const { return m_sorted[2]; }
    /// Takes the place of the greatest or the least in turn, as the side of the last number says.
    void add(std::int32_t number);

private:
    std::array<std::int32_t, 5> m_sorted{};
    std::int32_t m_dropGreatest = -1;  ///< all bits: it is; 0: the least is dropped
};

/// Decodes times of points as multiples of the last difference, of up to four sequences of points that take turns.
class LazTimes {
public:
    /// @param layered  in layers of formats 6 to 10, where a time that stays is told elsewhere
    explicit LazTimes(bool layered) : m_layered(layered), m_whole(32, 9) {}

    /// @param time  bits of the first one
    void start(std::uint64_t time);
    /// Bits of the next time.
    std::uint64_t decode(ArithmeticDecoder& decoder) {
        decodeCode(decoder);
        decodeLength(decoder);
        return decodeRest(decoder);
    }
    // The three parts of decode(), one after another.
    void decodeCode(ArithmeticDecoder& decoder);
    void decodeLength(ArithmeticDecoder& decoder) {
        if (m_pending != Pending::Nothing) {
            m_whole.decodeLength(decoder, m_context);
        }
    }
    std::uint64_t decodeRest(ArithmeticDecoder& decoder);

private:
    /// What follows the code of a time.
    enum class Pending : std::uint8_t { Nothing, First, Multiple, Extreme, Whole };
    bool step(ArithmeticDecoder& decoder);
    void expectDifference(std::uint32_t code);
    void countExtreme(std::int32_t difference);

    struct Sequence {
        std::uint64_t time = 0;
        std::int32_t difference = 0;
        int extremes = 0;  ///< differences far from the last one, since one was near
    };
    bool m_layered;
    std::array<Sequence, 4> m_sequences;
    std::size_t m_now = 0;
    std::size_t m_newest = 0;
    Pending m_pending = Pending::Nothing;
    std::uint32_t m_context = 0;
    std::int32_t m_expected = 0;
    SymbolModel m_codes;
    SymbolModel m_codesOfStill;  ///< where the last difference was 0
    IntegerDecoder m_whole;
};

/// Red, green and blue of a record as one number, as LazColours has them.
inline std::uint64_t colourAt(const unsigned char* bytes) {
    return littleAt<std::uint32_t>(bytes) | std::uint64_t{littleAt<std::uint16_t>(bytes + 4)} << 32;
}
inline void putColour(unsigned char* bytes, std::uint64_t colour) {
    const auto lower = static_cast<std::uint32_t>(colour);
    const auto upper = static_cast<std::uint16_t>(colour >> 32);
    std::memcpy(bytes, &lower, sizeof lower);
    std::memcpy(bytes + sizeof lower, &upper, sizeof upper);
}

/// Decodes colours as differences from the last one, byte by byte: green and blue from what red did. A colour is six bytes in one
/// number, the lower byte of red in its lowest, then the upper one, green and blue.
class LazColours {
public:
    void start();
    std::uint64_t decode(ArithmeticDecoder& decoder, std::uint64_t last) {
        decodeChanged(decoder, last);
        decodePart<0>(decoder);
        decodePart<1>(decoder);
        decodePart<2>(decoder);
        decodePart<4>(decoder);
        decodePart<3>(decoder);
        decodePart<5>(decoder);
        return colour();
    }
    // The steps of decode(), one after another. Both bytes of red come first, then the lower ones, then the upper ones.
    void decodeChanged(ArithmeticDecoder& decoder, std::uint64_t last) {
        m_bits = decoder.symbol(m_changed);
        // Of grey only red is told.
        m_bits &= (m_bits & 64) != 0 ? 127U : 3U;
        m_before = m_now = last;
    }
    template <std::size_t Part>
    void decodePart(ArithmeticDecoder& decoder) {
        if ((m_bits >> Part & 1) != 0) {
            takePart<Part>(decoder);
        }
    }
    std::uint64_t colour() const { return (m_bits & 64) != 0 ? m_now : (m_now & 0xffffU) * 0x1'0001'0001U; }

private:
    /// How far a byte moved since the last colour.
    std::int32_t moved(std::size_t of) const {
        const auto byteOf = [of](std::uint64_t colour) { return static_cast<std::int32_t>(colour >> 8 * of & 0xffU); };
        return byteOf(m_now) - byteOf(m_before);
    }
    template <std::size_t Part>
    void takePart(ArithmeticDecoder& decoder);

    std::uint32_t m_bits = 0;  ///< by byte: it changed; the seventh: it is no grey
    std::uint64_t m_before = 0;
    std::uint64_t m_now = 0;
    SymbolModel m_changed;
    std::array<SymbolModel, 6> m_differences;
};

template <std::size_t Part>
void LazColours::takePart(ArithmeticDecoder& decoder) {
    constexpr std::size_t half = Part % 2;
    const auto before = static_cast<std::uint32_t>(m_before >> 8 * Part & 0xffU);
    std::uint32_t expected = before;
    // What other bytes did foretells this one, within a byte.
    if constexpr (Part > 1) {
        const std::int32_t change = Part > 3 ? (moved(half) + moved(2 + half)) / 2 : moved(half);
        expected = static_cast<std::uint32_t>(std::clamp(static_cast<std::int32_t>(before) + change, 0, 255));
    }
    const std::uint32_t byte = (decoder.symbol(m_differences[Part]) + expected) & 0xffU;
    m_now ^= std::uint64_t{before ^ byte} << 8 * Part;
}

}  // namespace rubble::io
