#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/fe/fe_result.h"
#include "io/radioss/anim_reader.h"

using namespace rubble;

/// Reads any bytes as an animation file of OpenRadioss, or as one converted to VTK where they are text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string folder =
        (std::filesystem::temp_directory_path() / ("rubble-fuzz-" + std::to_string(::getpid()))).string();
    std::filesystem::create_directory(folder);
    const bool text = size > 0 && bytes[0] == '#';
    const std::string path = folder + (text ? "/X_001.vtk" : "/XA001");
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    try {
        const FeResult fe(text ? io::readConvertedAnim(path, {}, {}, Execution{}) : io::readAnim(path, {}, {}, Execution{}));
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            fe.state(k);
        }
    } catch (const Error&) {
    }
    std::filesystem::remove(path);
    return 0;
}
