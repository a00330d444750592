#include "io/fe/vtk/vtkhdf_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_tables.h"

using namespace rubble;

/// Opens tables made of any bytes as a VTKHDF grid.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path = (fuzzFolder() / "grid.vtkhdf").string();
    makeTables(bytes, size);
    fuzzResult([] { return io::readVtkHdf(path, {}, fuzzExecution()); });
    return 0;
}
