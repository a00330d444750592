#include "io/ansys/rst_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a result file of Ansys, with a list of deaths beside it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "rst.rst", [](const std::string& path) {
        std::ofstream(path + ".deaths.csv") << "1,0.5\n";
        return io::readRst(path, {}, {}, Execution{});
    });
    return 0;
}
