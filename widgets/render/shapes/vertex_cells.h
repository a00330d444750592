#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::render {

/// Joins points that lie in one cell of a cubic lattice, so that a surface gets by with fewer triangles (vertex clustering:
/// Rossignac and Borrel 1993). What is smaller than a cell is left out; what is larger keeps its shape to within one.
class VertexCells {
public:
    /// @param cell  edge of a cell, m, positive
    explicit VertexCells(double cell) : m_perCell(1.0 / cell) {}

    /// For each point the first of those in its cell.
    /// @param points  m; not finite ones stay alone
    std::vector<std::uint32_t> join(const std::vector<Eigen::Vector3f>& points);

private:
    struct Place {
        std::array<std::int32_t, 3> cell{};
        std::uint32_t point = nobody;
    };
    static constexpr std::uint32_t nobody = 0xffffffffu;
    Place& placeOf(const std::array<std::int32_t, 3>& cell);
    void grow();

    double m_perCell;
    std::vector<Place> m_places;  ///< a hash table, a power of two long
    std::size_t m_taken = 0;
};

/// What is left of a triangle (fourth `none`) or quadrilateral whose corners were joined: corners that stand twice in a row are
/// dropped. Returns false if no surface is left.
bool withoutRepeats(std::array<std::uint32_t, 4>& corners, std::uint32_t none);

}  // namespace rubble::render
