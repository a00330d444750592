#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Finds points that lie at one place, in units of the file. Each place is known by the first point that was put there.
class PlaceIndex {
public:
    static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

    /// @param tolerance  points no farther apart lie at one place; above zero
    explicit PlaceIndex(double tolerance) : m_tolerance(tolerance), m_cell(cellsPerTolerance * tolerance) {}

    double tolerance() const { return m_tolerance; }
    /// The point that stands for a place; `nowhere` where there is none, and for places that are no numbers.
    std::uint32_t find(const Vec3& place) const;
    /// Puts a point there if the place is free. @return  the point that stands for the place
    std::uint32_t put(const Vec3& place, std::uint32_t point);

private:
    static constexpr double cellsPerTolerance = 1024.0;
    using Cell = std::array<std::int64_t, 3>;

    struct CellHash {
        std::size_t operator()(const Cell& cell) const;
    };
    struct Entry {
        Vec3 place;
        std::uint32_t point;
    };

    bool usable(const Vec3& place) const;
    Cell cellOf(const Vec3& place) const;

    double m_tolerance, m_cell;
    std::unordered_map<Cell, std::vector<Entry>, CellHash> m_cells;
};

/// How far apart points of one place may lie: what is lost where the same number is written twice. Above zero.
double placeTolerance(const std::vector<Vec3>& places);

}  // namespace rubble::io
