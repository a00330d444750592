#include "io/fe/vtk/vtk_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a legacy VTK file: what follows its first line, since nothing else gets past that.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text = "# vtk DataFile Version 3.0\n" + std::string(reinterpret_cast<const char*>(bytes), size);
    fuzzFile(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), "grid.vtk",
             [](const std::string& path) { return io::readVtk(path, {}, fuzzExecution()); });
    return 0;
}
