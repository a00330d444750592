#include "io/fe/xdmf/xdmf_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_tables.h"

using namespace rubble;

/// Opens any bytes up to a mark of six bytes as XDMF; values lie in the text, in the file itself as binary items, or in tables made
/// of the bytes behind the mark.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(bytes), size);
    const std::size_t mark = std::min(all.find("TABLES"), size), tables = std::min(mark + 6, size);
    makeTables(bytes + tables, size - tables);
    fuzzFile(bytes, mark, "xdmf.xdmf", [](const std::string& path) { return io::readXdmf(path, {}, fuzzExecution()); });
    return 0;
}
