#include "io/fe/bodies/bodies_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a table of bodies.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "bodies.csv", [](const std::string& path) { return io::readBodies(path, {}, fuzzExecution()); });
    return 0;
}
