#include "io/xdmf/xdmf_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Opens any bytes as XDMF; values lie in the text, or in the file itself as binary items.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "xdmf.xdmf", [](const std::string& path) { return io::readXdmf(path, {}, {}, fuzzExecution()); });
    return 0;
}
