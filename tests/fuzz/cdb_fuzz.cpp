#include "io/fe/ansys/cdb_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a coded database of Ansys.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "cdb.cdb", [](const std::string& path) { return io::readCdbs(path, {}, fuzzExecution()); });
    return 0;
}
