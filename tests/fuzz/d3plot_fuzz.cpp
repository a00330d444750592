#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/fe/fe_result.h"
#include "io/d3plot/d3plot_family.h"
#include "io/d3plot/d3plot_reader.h"

using namespace rubble;

/// Reads any bytes as a d3plot family: the root up to a mark of eight bytes, then its first member.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string folder =
        (std::filesystem::temp_directory_path() / ("rubble-fuzz-" + std::to_string(::getpid()))).string();
    std::filesystem::create_directory(folder);
    const std::string root = folder + "/d3plot";
    const std::string all(reinterpret_cast<const char*>(bytes), size);
    const std::size_t mark = all.find("NEXTFILE");
    std::ofstream(root, std::ios::binary | std::ios::trunc) << all.substr(0, mark);
    if (mark != std::string::npos) {
        std::ofstream(root + "01", std::ios::binary | std::ios::trunc) << all.substr(mark + 8);
    }
    try {
        const FeResult fe(io::readD3plot(root, {}, {}, Execution{}));
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            fe.state(k);
        }
    } catch (const Error&) {
    }
    std::filesystem::remove(root);
    std::filesystem::remove(root + "01");
    return 0;
}
