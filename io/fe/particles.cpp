#include "io/fe/particles.h"

#include <array>
#include <cmath>

namespace rubble::io {

namespace {

constexpr std::array<std::array<int, 3>, 8> cubeCorners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

}  // namespace

void Particles::add(std::int64_t node, double volume) {
    nodes.push_back(node);
    halfEdges.push_back(0.5 * std::cbrt(volume));
}

void Particles::appendCorners(std::vector<Vec3>& positions) const {
    for (std::size_t p = 0; p < nodes.size(); ++p) {
        const Vec3 centre = positions[static_cast<std::size_t>(nodes[p])];
        for (const auto& corner : cubeCorners) {
            positions.push_back(centre + halfEdges[p] * Vec3(corner[0], corner[1], corner[2]));
        }
    }
}

void Particles::appendVelocities(std::vector<Vec3>& velocities) const {
    for (const std::int64_t node : nodes) {
        const Vec3 velocity = velocities[static_cast<std::size_t>(node)];
        velocities.insert(velocities.end(), cubeCorners.size(), velocity);
    }
}

void Particles::appendIds(std::vector<std::int64_t>& ids) const {
    for (const std::int64_t node : nodes) {
        const std::int64_t id = ids[static_cast<std::size_t>(node)];
        ids.insert(ids.end(), cubeCorners.size(), id);
    }
}

std::vector<std::int64_t> Particles::cornersOf(std::size_t p, std::size_t fileNodes) {
    std::vector<std::int64_t> corners;
    for (std::size_t i = 0; i < cubeCorners.size(); ++i) {
        corners.push_back(static_cast<std::int64_t>(fileNodes + cubeCorners.size() * p + i));
    }
    return corners;
}

double spacingVolume(const Aabb& bounds, std::size_t count) {
    const auto number = static_cast<double>(count);
    const Vec3 size = bounds.sizes();
    const double box = size.prod();
    double volume = 0.0;
    if (box > 0.0) {
        volume = (size + Vec3::Constant(std::cbrt(box / number))).prod() / number;
    } else {
        // A plane or a row of particles.
        const double edge = size.maxCoeff() / number;
        volume = edge * edge * edge;
    }
    return std::isfinite(volume) && volume > 0.0 ? volume : 1.0;
}

}  // namespace rubble::io
