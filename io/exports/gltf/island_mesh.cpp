#include "io/exports/gltf/island_mesh.h"

#include <algorithm>
#include <array>

namespace rubble::io {

namespace {

/// A face as the corners of its element stand, fourth 0xffffffff for a triangle.
struct Face {
    std::array<std::uint32_t, 4> key{};  ///< nodes, ascending
    std::array<std::uint32_t, 4> nodes{};
    ElementIndex element{};
};

std::vector<Face> facesOfElements(const Mesh& mesh, const std::vector<ElementIndex>& elements) {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<Face> faces;
    for (const ElementIndex e : elements) {
        const auto corners = mesh.cornersOf(e);
        for (const auto& local : facesOf(mesh.shapes[at(e)])) {
            Face face{{}, {none, none, none, none}, e};
            for (std::size_t i = 0; i < 4 && local[i] >= 0; ++i) {
                face.nodes[i] = corners[static_cast<std::size_t>(local[i])];
            }
            face.key = face.nodes;
            std::sort(face.key.begin(), face.key.end());
            faces.push_back(face);
            if (isShell(mesh.shapes[at(e)])) {
                // A sheet is seen from both sides.
                std::reverse(face.nodes.begin(), face.nodes.begin() + (face.nodes[3] == none ? 3 : 4));
                faces.push_back(face);
            }
        }
    }
    std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
    return faces;
}

}  // namespace

std::map<ComponentId, SurfacePart> islandSurface(const IslandRecord& island, const FeResult& fe,
                                                 const std::vector<ComponentId>& componentOf) {
    const Mesh& mesh = fe.mesh();
    const auto then = fe.state(std::min<std::size_t>(island.state, fe.stateCount() - 1));
    const Pose toBody = island.inFe.inverse();
    const std::vector<Face> faces = facesOfElements(mesh, island.elements);
    std::map<ComponentId, SurfacePart> parts;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].key == faces[i].key) {
            ++end;
        }
        // Two solids that share a face hide it.
        const bool inner = end > i + 1 && !isShell(mesh.shapes[at(faces[i].element)]);
        for (std::size_t k = i; k < end && !inner; ++k) {
            SurfacePart& part = parts[componentOf[at(faces[k].element)]];
            const auto first = static_cast<std::uint32_t>(part.points.size());
            const bool triangle = faces[k].nodes[3] == 0xffffffffu;
            for (std::size_t c = 0; c < (triangle ? 3u : 4u); ++c) {
                part.points.push_back(toBody * then->positions[faces[k].nodes[c]]);
            }
            part.corners.insert(part.corners.end(), {first, first + 1, first + 2});
            if (!triangle) {
                part.corners.insert(part.corners.end(), {first, first + 2, first + 3});
            }
        }
        i = end;
    }
    return parts;
}

}  // namespace rubble::io
