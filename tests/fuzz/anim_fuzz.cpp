#include <cstdint>
#include <filesystem>
#include <string>

#include "io/fe/radioss/anim_reader.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Reads any bytes as an animation file of OpenRadioss, or as one converted to VTK where they are text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const bool text = size > 0 && bytes[0] == '#';
    fuzzFile(bytes, size, text ? "X_001.vtk" : "XA001", [text](const std::string& path) {
        return text ? io::readConvertedAnim(path, {}, fuzzExecution()) : io::readAnim(path, {}, fuzzExecution());
    });
    return 0;
}
