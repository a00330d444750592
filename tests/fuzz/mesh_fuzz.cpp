#include <cmath>
#include <string>

#include "io/site/site_mesh_file.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Reads any bytes as a mesh of the surroundings; what is read has points where its triangles say.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    constexpr const char* names[] = {"mesh.obj", "mesh.ply", "mesh.gltf", "mesh.glb"};
    const std::string path = layDown(bytes + 1, size - 1, names[bytes[0] % 4]);
    try {
        const io::SiteMeshReading reading = io::readSiteMesh(path, Frame(), Site(), fuzzExecution());
        for (const auto& triangle : reading.mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                if (corner >= reading.mesh.points.size() || !reading.mesh.points[corner].allFinite()) {
                    __builtin_trap();
                }
            }
        }
    } catch (const Error&) {
    }
    return 0;
}
