#pragma once

#include <array>
#include <cstdint>
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
    std::uint64_t decode(ArithmeticDecoder& decoder);

private:
    bool step(ArithmeticDecoder& decoder);
    void addDifference(ArithmeticDecoder& decoder, std::uint32_t code);
    void takeWhole(ArithmeticDecoder& decoder);
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
    SymbolModel m_codes;
    SymbolModel m_codesOfStill;  ///< where the last difference was 0
    IntegerDecoder m_whole;
};

/// Decodes colours as differences from the last one, byte by byte: green and blue from what red did.
class LazColours {
public:
    using Colour = std::array<std::uint16_t, 3>;
    void start();
    Colour decode(ArithmeticDecoder& decoder, const Colour& last);

private:
    SymbolModel m_changed;
    std::array<SymbolModel, 6> m_differences;
};

}  // namespace rubble::io
