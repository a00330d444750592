#include "io/fe/vtk/vtk_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as an unstructured grid of VTK XML.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "grid.vtu", [](const std::string& path) { return io::readVtk(path, {}, fuzzExecution()); });
    return 0;
}
