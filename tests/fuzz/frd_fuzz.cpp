#include "io/fe/calculix/frd_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a result file of CalculiX.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "frd.frd", [](const std::string& path) { return io::readFrd(path, {}, fuzzExecution()); });
    return 0;
}
