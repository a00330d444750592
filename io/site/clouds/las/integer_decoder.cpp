#include "io/site/clouds/las/integer_decoder.h"

#include <algorithm>

namespace rubble::io {

namespace {

/// Bits of a difference that have a model.
constexpr std::uint32_t modelledBits = 8;

}  // namespace

IntegerDecoder::IntegerDecoder(std::uint32_t bits, std::uint32_t contexts) : m_bits(bits), m_lengths(contexts) {
    start();
}

void IntegerDecoder::start() {
    for (SymbolModel& model : m_lengths) {
        model.stop();
    }
    for (SymbolModel& model : m_differences) {
        model.stop();
    }
    m_unit.start();
    m_length = 0;
}

std::int32_t IntegerDecoder::decode(ArithmeticDecoder& decoder, std::int32_t expected, std::uint32_t context) {
    SymbolModel& lengths = m_lengths[context];
    if (!lengths.started()) {
        lengths.start(m_bits + 1);
    }
    m_length = decoder.symbol(lengths);
    const std::uint32_t number = static_cast<std::uint32_t>(expected) + difference(decoder);
    return static_cast<std::int32_t>(m_bits < 32 ? number & ((std::uint32_t{1} << m_bits) - 1) : number);
}

std::uint32_t IntegerDecoder::difference(ArithmeticDecoder& decoder) {
    if (m_length == 0) {
        return decoder.bit(m_unit);
    }
    if (m_length == 32) {
        return std::uint32_t{1} << 31;
    }
    SymbolModel& model = m_differences[m_length];
    if (!model.started()) {
        model.start(std::uint32_t{1} << std::min(m_length, modelledBits));
    }
    std::uint32_t code = decoder.symbol(model);
    if (m_length > modelledBits) {
        const std::uint32_t rest = m_length - modelledBits;
        code = code << rest | decoder.bits(rest);
    }
    // Upper half: positive differences; lower half: negative ones.
    const std::uint32_t half = std::uint32_t{1} << (m_length - 1);
    return code >= half ? code + 1 : code - (2 * half - 1);
}

}  // namespace rubble::io
