#include "widgets/render/shapes/intact_outline.h"

#include <algorithm>
#include <limits>

#include "widgets/render/shapes/structure_faces.h"

namespace rubble::render {
namespace {

constexpr double sharpTurn = 0.866;  // cosine of 30 degrees

/// A side of a surface face, with that face's direction.
struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    Vec3 normal = Vec3::Zero();
};

ShowTimes alwaysOf(const FeResult& fe, const std::vector<std::uint8_t>& hidden) {
    ShowTimes times;
    times.offsets.push_back(0);
    for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
        if (fe.activity().active(0, idAt<ElementIndex>(e)) && (hidden.empty() || hidden[e] == 0)) {
            times.spans.push_back({-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()});
        }
        times.offsets.push_back(static_cast<std::uint32_t>(times.spans.size()));
    }
    return times;
}

/// True if the faces of a shared side run on in one direction.
bool smooth(std::vector<Edge>::const_iterator begin, std::vector<Edge>::const_iterator end) {
    return end - begin == 2 && begin->normal.dot((begin + 1)->normal) > sharpTurn;
}

}  // namespace

std::vector<Eigen::Vector3f> intactOutline(const FeResult& fe, const std::vector<std::uint8_t>& hidden) {
    const std::vector<Vec3>& nodes = fe.mesh().nodes;
    const StructureFaces surface(fe.mesh(), alwaysOf(fe, hidden));
    std::vector<Edge> edges;
    for (const StructureFaces::Face& face : surface.faces()) {
        std::size_t corners = 0;
        while (corners < 4 && face.nodes[corners] != StructureFaces::none) {
            ++corners;
        }
        const auto p = [&](std::size_t i) -> const Vec3& { return nodes[face.nodes[i]]; };
        const Vec3 normal = corners < 3 ? Vec3(Vec3::Zero()) : Vec3((p(1) - p(0)).cross(p(corners - 1) - p(0)).normalized());
        for (std::size_t i = 0; i < (corners == 2 ? 1 : corners); ++i) {
            const auto [low, high] = std::minmax(face.nodes[i], face.nodes[(i + 1) % corners]);
            edges.push_back({low, high, normal});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
    std::vector<Eigen::Vector3f> ends;
    for (auto begin = edges.cbegin(); begin != edges.cend();) {
        const auto end =
            std::find_if(begin, edges.cend(), [&](const Edge& e) { return e.low != begin->low || e.high != begin->high; });
        if (!smooth(begin, end)) {
            ends.push_back(nodes[begin->low].cast<float>());
            ends.push_back(nodes[begin->high].cast<float>());
        }
        begin = end;
    }
    return ends;
}

}  // namespace rubble::render
