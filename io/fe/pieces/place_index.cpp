#include "io/fe/pieces/place_index.h"

#include <cmath>

namespace rubble::io {

namespace {

// Of the size of all places: a few last digits of single precision.
constexpr double relativeTolerance = 1e-7;
constexpr double mostCells = 9e15;

}  // namespace

std::size_t PlaceIndex::CellHash::operator()(const Cell& cell) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::int64_t number : cell) {
        hash = (hash ^ static_cast<std::uint64_t>(number)) * 0xff51afd7ed558ccdu;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

bool PlaceIndex::usable(const Vec3& place) const {
    return place.allFinite() && place.cwiseAbs().maxCoeff() < mostCells * m_cell;
}

PlaceIndex::Cell PlaceIndex::cellOf(const Vec3& place) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cell[axis] = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(axis)] / m_cell));
    }
    return cell;
}

std::uint32_t PlaceIndex::find(const Vec3& place) const {
    if (!usable(place)) {
        return nowhere;
    }
    const Vec3 reach = Vec3::Constant(m_tolerance);
    const Cell low = cellOf(place - reach), high = cellOf(place + reach);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                const auto found = m_cells.find({x, y, z});
                if (found == m_cells.end()) {
                    continue;
                }
                for (const Entry& entry : found->second) {
                    if ((entry.place - place).cwiseAbs().maxCoeff() <= m_tolerance) {
                        return entry.point;
                    }
                }
            }
        }
    }
    return nowhere;
}

std::uint32_t PlaceIndex::put(const Vec3& place, std::uint32_t point) {
    if (!usable(place)) {
        return point;
    }
    const std::uint32_t known = find(place);
    if (known != nowhere) {
        return known;
    }
    m_cells[cellOf(place)].push_back({place, point});
    return point;
}

double placeTolerance(const std::vector<Vec3>& places) {
    Aabb bounds;
    for (const Vec3& place : places) {
        if (place.allFinite() && place.cwiseAbs().maxCoeff() < 1e9) {
            bounds.extend(place);
        }
    }
    const double size = bounds.isEmpty() ? 0.0 : bounds.sizes().norm();
    return size > 0.0 ? relativeTolerance * size : relativeTolerance;
}

}  // namespace rubble::io
