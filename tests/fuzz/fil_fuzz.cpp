#include "io/fe/abaqus/fil_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a results file of Abaqus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "fil.fil", [](const std::string& path) { return io::readFil(path, {}, fuzzExecution()); });
    return 0;
}
