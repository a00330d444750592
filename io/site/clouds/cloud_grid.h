#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Points gathered in cells, of which heights at the middles of the cells are made.
class CloudGrid {
public:
    /// @param low   corner of the first cell; @param step  widths of a cell, all in units of the points
    CloudGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& step, std::size_t columns, std::size_t rows);

    /// @return false: it lies beside the grid
    bool add(const Vec3& place);

    std::size_t columns() const { return m_columns; }
    std::size_t rows() const { return m_rows; }
    const Eigen::Vector2d& low() const { return m_low; }
    const Eigen::Vector2d& step() const { return m_step; }
    /// Cells with points.
    std::size_t covered() const;
    /// Cells with points lie along a line or in one spot: they spread across it by less than two cells side by side would.
    bool inLine() const;
    /// Points of a cell, in the median of those that have any.
    std::uint32_t pointsInMedian() const;
    /// [rows * columns] from the lowest y; not a number where no point lies.
    std::vector<double> heights() const;

private:
    struct Cell {
        double x = 0.0;  ///< sums; x and y in cells from the middle, z from the first point of the grid
        double y = 0.0;
        double z = 0.0;
        std::uint32_t points = 0;
    };
    double heightAt(std::size_t column, std::size_t row) const;

    Eigen::Vector2d m_low;
    Eigen::Vector2d m_step;
    std::size_t m_columns;
    std::size_t m_rows;
    double m_zero = 0.0;
    bool m_begun = false;
    std::vector<Cell> m_cells;
};

}  // namespace rubble::io
