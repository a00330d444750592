#include "widgets/render/vertex_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rubble::render {

std::vector<std::uint32_t> VertexCells::join(const std::vector<Eigen::Vector3f>& points) {
    constexpr double furthest = 1e9;  // cells from the origin that a number can count
    std::vector<std::uint32_t> first(points.size());
    std::iota(first.begin(), first.end(), 0u);
    m_places.clear();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Vec3 place = points[i].cast<double>() * m_perCell;
        if (!place.allFinite() || place.cwiseAbs().maxCoeff() > furthest) {
            continue;
        }
        const auto cell = [&](int axis) { return static_cast<std::int32_t>(std::floor(place[axis])); };
        m_places.push_back({{cell(0), cell(1), cell(2)}, i});
    }
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return std::tie(a.cell, a.point) < std::tie(b.cell, b.point); });
    for (std::size_t i = 1; i < m_places.size(); ++i) {
        if (m_places[i].cell == m_places[i - 1].cell) {
            first[m_places[i].point] = first[m_places[i - 1].point];
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
