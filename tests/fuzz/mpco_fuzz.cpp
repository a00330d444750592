#include "io/fe/opensees/mpco_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_tables.h"

using namespace rubble;

/// Opens tables made of any bytes as an MPCO file of OpenSees.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path = (fuzzFolder() / "wall.mpco").string();
    makeTables(bytes, size);
    fuzzResult([] { return io::readMpco(path, {}, fuzzExecution()); });
    return 0;
}
