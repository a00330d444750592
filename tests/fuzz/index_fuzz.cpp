#include "io/fe/vtk/grid_index.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Reads any bytes as an index of a VTK series (.pvd, .pvtu, .series) beside two files that it may list.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string grid = R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid/></VTKFile>)";
    static const std::string member = layDown(grid.data(), grid.size(), "a.vtu");
    static const std::string other = layDown(grid.data(), grid.size(), "b.vtu");
    const std::string path = layDown(bytes, size, "index.pvd");
    io::canonicalIndex(member);
    io::canonicalIndex(path);
    try {
        io::indexGrids(path, false);
    } catch (const Error&) {
    }
    return 0;
}
