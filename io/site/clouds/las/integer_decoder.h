#pragma once

#include <algorithm>
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
    std::int32_t decode(ArithmeticDecoder& decoder, std::int32_t expected, std::uint32_t context) {
        decodeLength(decoder, context);
        return decodeRest(decoder, expected);
    }
    /// The first half of decode(): how many bits the difference takes.
    void decodeLength(ArithmeticDecoder& decoder, std::uint32_t context);
    /// The second half: the number.
    std::int32_t decodeRest(ArithmeticDecoder& decoder, std::int32_t expected);
    /// Bits that the last difference took.
    std::uint32_t length() const { return m_length; }

private:
    std::uint32_t difference(ArithmeticDecoder& decoder);

    /// Bits of a difference that have a model.
    static constexpr std::uint32_t modelledBits = 8;
    std::uint32_t m_bits;
    std::uint32_t m_mask;  ///< the bits of the numbers
    std::uint32_t m_length = 0;
    std::vector<SymbolModel> m_lengths;
    std::array<SymbolModel, 33> m_differences;  ///< by length, from 1
    BitModel m_unit;                            ///< of differences of 0 and 1
};

inline void IntegerDecoder::decodeLength(ArithmeticDecoder& decoder, std::uint32_t context) {
    SymbolModel& lengths = m_lengths[context];
    if (!lengths.started()) {
        lengths.start(m_bits + 1);
    }
    m_length = decoder.symbol(lengths);
}

inline std::int32_t IntegerDecoder::decodeRest(ArithmeticDecoder& decoder, std::int32_t expected) {
    const std::uint32_t number = static_cast<std::uint32_t>(expected) + difference(decoder);
    return static_cast<std::int32_t>(number & m_mask);
}

inline std::uint32_t IntegerDecoder::difference(ArithmeticDecoder& decoder) {
    if (m_length == 0) {
        return decoder.bit(m_unit);
    }
    if (m_length == 32) {
        return std::uint32_t{1} << 31;
    }
    SymbolModel& model = m_differences[m_length];
    if (!model.started()) [[unlikely]] {
        model.start(std::uint32_t{1} << std::min(m_length, modelledBits));
    }
    std::uint32_t code = decoder.symbol(model);
    if (m_length > modelledBits) {
        const std::uint32_t rest = m_length - modelledBits;
        code = code << rest | decoder.bits(rest);
    }
    // Upper half: positive differences; lower half: negative ones.
    const std::uint32_t half = std::uint32_t{1} << (m_length - 1);
    const std::uint32_t negative = 0U - static_cast<std::uint32_t>(code < half);
    return code + 1 - (2 * half & negative);
}

}  // namespace rubble::io
