#include <cmath>
#include <string>

#include "io/fe/bodies/body_meshes.h"
#include "io/site/site_mesh_file.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

namespace {

/// The same bytes as the shape of a body: what is taken is a solid.
void fuzzBody(const std::string& name) {
    try {
        const auto hull = io::BodyMeshes((fuzzFolder() / "bodies.csv").string()).shape(name, 2);
        if (!(hull->volume > 0.0) || !std::isfinite(hull->volume) || !hull->sides.allFinite()) {
            __builtin_trap();
        }
    } catch (const Error&) {
    }
}

}  // namespace

/// Reads any bytes as a mesh of the surroundings and as that of a body; what is read has points where its triangles say.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    // The committed corpus takes the first four by their remainder of four.
    constexpr const char* names[] = {"mesh.obj", "mesh.ply", "mesh.gltf", "mesh.glb", "mesh.stl"};
    const std::string name = bytes[0] == 's' ? names[4] : names[bytes[0] % 4];
    const std::string path = layDown(bytes + 1, size - 1, name);
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
    fuzzBody(name);
    return 0;
}
