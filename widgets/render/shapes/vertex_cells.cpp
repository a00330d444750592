#include "widgets/render/shapes/vertex_cells.h"

#include <cmath>

namespace rubble::render {

namespace {

constexpr std::size_t fewest = 256;  // places in the table

std::size_t hashOf(const std::array<std::int32_t, 3>& cell) {
    std::uint64_t hash = 0;
    for (const std::int32_t axis : cell) {
        hash = (hash ^ static_cast<std::uint32_t>(axis)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

}  // namespace

/// Where a cell stands in the table, or is to stand.
VertexCells::Place& VertexCells::placeOf(const std::array<std::int32_t, 3>& cell) {
    const std::size_t mask = m_places.size() - 1;
    std::size_t i = hashOf(cell) & mask;
    while (m_places[i].point != nobody && m_places[i].cell != cell) {
        i = (i + 1) & mask;
    }
    return m_places[i];
}

void VertexCells::grow() {
    std::vector<Place> before(2 * m_places.size());
    before.swap(m_places);
    for (const Place& place : before) {
        if (place.point != nobody) {
            placeOf(place.cell) = place;
        }
    }
}

std::vector<std::uint32_t> VertexCells::join(const std::vector<Eigen::Vector3f>& points) {
    constexpr double furthest = 1e9;  // cells from the origin that a number can count
    std::vector<std::uint32_t> first(points.size());
    m_places.assign(fewest, {});
    m_taken = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        first[i] = i;
        const Vec3 place = points[i].cast<double>() * m_perCell;
        if (!(place.cwiseAbs().maxCoeff() <= furthest) || !place.allFinite()) {
            continue;
        }
        const auto cell = [&](int axis) {
            const auto towardsZero = static_cast<std::int32_t>(place[axis]);
            return towardsZero - (place[axis] < towardsZero ? 1 : 0);
        };
        const std::array<std::int32_t, 3> own{cell(0), cell(1), cell(2)};
        Place& taken = placeOf(own);
        if (taken.point != nobody) {
            first[i] = taken.point;
            continue;
        }
        taken = {own, i};
        if (2 * ++m_taken > m_places.size()) {
            grow();
        }
    }
    return first;
}

bool withoutRepeats(std::array<std::uint32_t, 4>& corners, std::uint32_t none) {
    std::array<std::uint32_t, 4> left{none, none, none, none};
    std::size_t kept = 0;
    for (const std::uint32_t corner : corners) {
        if (corner != none && (kept == 0 || left[kept - 1] != corner)) {
            left[kept++] = corner;
        }
    }
    if (kept > 1 && left[kept - 1] == left[0]) {
        left[--kept] = none;
    }
    // Opposite corners of a quadrilateral that are one fold it up.
    const bool folded = kept == 4 && (left[0] == left[2] || left[1] == left[3]);
    corners = left;
    return kept >= 3 && !folded;
}

}  // namespace rubble::render
