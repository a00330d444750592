#include "io/fe/med/med_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_med.h"

using namespace rubble;

/// Opens a mesh and fields made of any bytes as a MED file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path = (fuzzFolder() / "wall.rmed").string();
    makeMed(bytes, size);
    fuzzResult([] { return io::readMed(path, {}, fuzzExecution()); });
    return 0;
}
