#include "io/exodus/exodus_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as an Exodus II result and audits what comes out.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "exodus.exo", [](const std::string& path) { return io::readExodus(path, {}, {}, fuzzExecution()); });
    return 0;
}
