#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/site/clouds/las/arithmetic_decoder.h"

namespace rubble::io {

/// Decodes whole numbers as differences from what was expected: first how many bits the difference takes, then those bits, the
/// upper eight of them by a model.
class IntegerDecoder {
public:
    /// @param bits  of the numbers, 16 or 32
    /// @param contexts  kinds of numbers, each with a model of its own for the length of the difference
    IntegerDecoder(std::uint32_t bits, std::uint32_t contexts);

    /// Forgets what was learned.
    void start();
    /// Numbers of fewer than 32 bits come as 0 to 2^bits - 1.
    std::int32_t decode(ArithmeticDecoder& decoder, std::int32_t expected, std::uint32_t context);
    /// Bits that the last difference took.
    std::uint32_t length() const { return m_length; }

private:
    std::uint32_t difference(ArithmeticDecoder& decoder);

    std::uint32_t m_bits;
    std::uint32_t m_length = 0;
    std::vector<SymbolModel> m_lengths;
    std::array<SymbolModel, 33> m_differences;  ///< by length, from 1
    BitModel m_unit;                            ///< of differences of 0 and 1
};

}  // namespace rubble::io
