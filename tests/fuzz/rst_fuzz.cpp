#include "io/fe/ansys/rst_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a result file of Ansys, with a list of deaths beside it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string deaths = layDown("1,0.5\n", 6, "rst.rst.deaths.csv");
    fuzzFile(bytes, size, "rst.rst", [](const std::string& path) { return io::readRst(path, {}, fuzzExecution()); });
    return 0;
}
