#include <cstring>

#include "io/fe/exodus/exodus_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as an Exodus II result of classic netCDF and audits what comes out. Files of HDF5 hold the same variables; the
/// library that unpacks them is tried in a child process, and is no part of this. Nothing else is recognised as Exodus II.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 4 || std::memcmp(bytes, "CDF", 3) != 0) {
        return -1;
    }
    fuzzFile(bytes, size, "exodus.exo", [](const std::string& path) { return io::readExodus(path, {}, fuzzExecution()); });
    return 0;
}
