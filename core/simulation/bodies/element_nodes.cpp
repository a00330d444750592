#include "core/simulation/bodies/element_nodes.h"

#include <algorithm>

namespace rubble {

std::vector<std::uint32_t> nodesOf(const Mesh& mesh, std::span<const ElementIndex> elements) {
    std::vector<std::uint32_t> nodes;
    for (const ElementIndex e : elements) {
        const auto corners = mesh.cornersOf(e);
        nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace rubble
