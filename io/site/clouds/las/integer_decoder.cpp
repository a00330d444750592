#include "io/site/clouds/las/integer_decoder.h"

namespace rubble::io {

IntegerDecoder::IntegerDecoder(std::uint32_t bits, std::uint32_t contexts)
    : m_bits(bits), m_mask(~std::uint32_t{0} >> (32 - bits)), m_lengths(contexts) {
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

}  // namespace rubble::io
