#include "io/fe_copy/copy_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a copy of a result.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "copy.h5", [](const std::string& path) { return io::readFeCopy(path, {}, {}, Execution{}); });
    return 0;
}
