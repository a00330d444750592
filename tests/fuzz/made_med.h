#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// Makes what every io::MedFile of this program then holds, whatever its path: made_med.cpp stands in for libmed, which the product
/// tries in a child process, so that what is fuzzed is what we do with what it hands over. Bytes are a row of entries: kind (node,
/// block of cells, group, field, step, values), then its values.
void makeMed(const std::uint8_t* bytes, std::size_t size);

}  // namespace rubble
