#include "io/fe/fe_copy/copy_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_tables.h"

using namespace rubble;

/// Opens tables made of any bytes as a copy of a result; its states are sought in the same bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    makeTables(bytes, size);
    fuzzFile(bytes, size, "copy.h5", [](const std::string& path) { return io::readFeCopy(path, {}, fuzzExecution()); });
    return 0;
}
