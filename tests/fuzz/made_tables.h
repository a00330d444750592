#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// Makes the tables that every io::Hdf5Table of this program then holds, whatever its path: made_tables.cpp stands in for the
/// library, which the product tries in a child process, so that what is fuzzed is what we do with what it hands over. Bytes are a
/// row of entries: kind (attribute of a number or a text, table of whole or of real numbers), name (of a list), values.
void makeTables(const std::uint8_t* bytes, std::size_t size);

}  // namespace rubble
