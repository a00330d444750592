#include "io/fe/marc/marc_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as a post file of MSC Marc.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "marc.t19", [](const std::string& path) { return io::readMarc(path, {}, fuzzExecution()); });
    return 0;
}
