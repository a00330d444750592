#include "io/site/clouds/cloud_grid.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/unknown.h"

namespace rubble::io {

CloudGrid::CloudGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& step, std::size_t columns, std::size_t rows)
    : m_low(low), m_step(step), m_columns(columns), m_rows(rows), m_cells(columns * rows) {}

bool CloudGrid::add(const Vec3& place) {
    const double u = (place.x() - m_low.x()) / m_step.x();
    const double v = (place.y() - m_low.y()) / m_step.y();
    if (!(u >= 0.0 && v >= 0.0 && u < static_cast<double>(m_columns) && v < static_cast<double>(m_rows))) {
        return false;
    }
    if (!m_begun) {
        m_begun = true;
        m_zero = place.z();
    }
    Cell& cell = m_cells[static_cast<std::size_t>(v) * m_columns + static_cast<std::size_t>(u)];
    cell.x += u - std::floor(u) - 0.5;
    cell.y += v - std::floor(v) - 0.5;
    cell.z += place.z() - m_zero;
    ++cell.points;
    return true;
}

std::size_t CloudGrid::covered() const {
    return static_cast<std::size_t>(
        std::count_if(m_cells.begin(), m_cells.end(), [](const Cell& cell) { return cell.points > 0; }));
}

bool CloudGrid::inLine() const {
    constexpr double leastSpread = 0.45;  // of the side of a cell, standard deviation across the line; of two rows it is a half
    if (m_columns < 2 || m_rows < 2) {
        return true;
    }
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < m_cells.size(); ++k) {
        const Cell& cell = m_cells[k];
        if (cell.points > 0) {
            const Eigen::Vector2d off = Eigen::Vector2d(cell.x, cell.y) / static_cast<double>(cell.points);
            const std::size_t row = k / m_columns;
            const Eigen::Vector2d place = off + Eigen::Vector2d(static_cast<double>(k - row * m_columns), static_cast<double>(row));
            sum += place;
            squares += place * place.transpose();
            count += 1.0;
        }
    }
    if (count < 1.0) {
        return false;
    }
    const Eigen::Vector2d mean = sum / count;
    const Eigen::Matrix2d spread = squares / count - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    return axes.eigenvalues()[0] < leastSpread * leastSpread;
}

std::uint32_t CloudGrid::pointsInMedian() const {
    std::vector<std::uint32_t> counts;
    for (const Cell& cell : m_cells) {
        if (cell.points > 0) {
            counts.push_back(cell.points);
        }
    }
    if (counts.empty()) {
        return 0;
    }
    const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
    std::nth_element(counts.begin(), middle, counts.end());
    return *middle;
}

/// The mean of the points of a cell, brought to its middle along the slope of the means around it.
double CloudGrid::heightAt(std::size_t column, std::size_t row) const {
    const Cell& own = m_cells[row * m_columns + column];
    if (own.points == 0) {
        return unknown;
    }
    const auto count = static_cast<double>(own.points);
    const Eigen::Vector2d off = Eigen::Vector2d(own.x, own.y) / count;
    const double mean = own.z / count;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Vector2d slopes = Eigen::Vector2d::Zero();
    double least = mean;
    double most = mean;
    for (std::size_t j = row > 0 ? row - 1 : 0; j <= std::min(row + 1, m_rows - 1); ++j) {
        for (std::size_t i = column > 0 ? column - 1 : 0; i <= std::min(column + 1, m_columns - 1); ++i) {
            const Cell& cell = m_cells[j * m_columns + i];
            if (cell.points == 0) {
                continue;
            }
            const auto points = static_cast<double>(cell.points);
            const Eigen::Vector2d steps(static_cast<double>(i) - static_cast<double>(column),
                                        static_cast<double>(j) - static_cast<double>(row));
            const Eigen::Vector2d apart = steps + Eigen::Vector2d(cell.x, cell.y) / points - off;
            const double height = cell.z / points;
            spread += points * apart * apart.transpose();
            slopes += points * apart * (height - mean);
            least = std::min(least, height);
            most = std::max(most, height);
        }
    }
    const double area = spread.determinant();
    double risen = 0.0;
    // Neighbours on one line tell no slope across it.
    if (area > 1e-3 * spread.trace() * spread.trace()) {
        risen = -(spread.inverse() * slopes).dot(off);
    }
    const double room = most - least;
    return m_zero + mean + std::clamp(risen, -room, room);
}

std::vector<double> CloudGrid::heights() const {
    std::vector<double> heights;
    heights.reserve(m_cells.size());
    for (std::size_t row = 0; row < m_rows; ++row) {
        for (std::size_t column = 0; column < m_columns; ++column) {
            heights.push_back(heightAt(column, row));
        }
    }
    return heights;
}

}  // namespace rubble::io
