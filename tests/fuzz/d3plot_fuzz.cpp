#include <cstdint>
#include <filesystem>
#include <string>

#include "io/fe/d3plot/d3plot_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Reads any bytes as a d3plot family: the root up to a mark of eight bytes, then its first member.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(bytes), size);
    const std::size_t mark = std::min(all.find("NEXTFILE"), size);
    const std::string root = layDown(all.data(), mark, "d3plot");
    if (mark < size) {
        layDown(all.data() + mark + 8, size - mark - 8, "d3plot01");
    }
    fuzzResult([&] { return io::readD3plot(root, {}, fuzzExecution()); });
    if (mark < size) {
        std::filesystem::remove(root + "01");
    }
    return 0;
}
