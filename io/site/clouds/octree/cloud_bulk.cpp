#include "io/site/clouds/octree/cloud_bulk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rubble::io {

namespace {

constexpr std::size_t bulkSample = 65'536;
constexpr double metresPerDegree = 111'000.0;

using Range = std::pair<double, double>;

/// The shortest range that holds half of some numbers. @param sorted  not empty
Range shortestHalf(const std::vector<double>& sorted) {
    const std::size_t half = sorted.size() / 2;
    Range best(sorted[0], sorted[half]);
    for (std::size_t first = 1; first + half < sorted.size(); ++first) {
        if (sorted[first + half] - sorted[first] < best.second - best.first) {
            best = {sorted[first], sorted[first + half]};
        }
    }
    return best;
}

/// A range with all that no wide gap parts from it. @param least  width of a range that gaps are held against
Range grown(const std::vector<double>& sorted, Range range, double least) {
    auto low = std::lower_bound(sorted.begin(), sorted.end(), range.first);
    auto high = std::upper_bound(low, sorted.end(), range.second);
    for (bool more = true; more;) {
        more = false;
        const double gap = farTimes * std::max(least, range.second - range.first);
        if (low != sorted.begin() && range.first - *(low - 1) <= gap) {
            range.first = *--low;
            more = true;
        }
        if (high != sorted.end() && *high - range.second <= gap) {
            range.second = *high++;
            more = true;
        }
    }
    return range;
}

std::vector<double> sortedAlong(const std::vector<Vec3>& places, int axis) {
    std::vector<double> along;
    along.reserve(places.size());
    for (const Vec3& place : places) {
        along.push_back(place[axis]);
    }
    std::sort(along.begin(), along.end());
    return along;
}

}  // namespace

void CloudBulk::add(const Vec3& place) {
    if (m_seen++ % m_every != 0) {
        return;
    }
    if (m_places.size() == bulkSample) {
        for (std::size_t i = 0; i < bulkSample / 2; ++i) {
            m_places[i] = m_places[2 * i];
        }
        m_places.resize(bulkSample / 2);
        m_every *= 2;
    }
    m_places.push_back(place);
}

Aabb CloudBulk::box(const CloudUnits& units) const {
    const double across = units.degrees ? metresPerDegree : units.metres;
    const Vec3 metres(across, across, units.heightMetres);
    std::vector<Vec3> places = m_places;
    const auto order = [](const Vec3& one, const Vec3& other) {
        return std::tuple(one.x(), one.y(), one.z()) < std::tuple(other.x(), other.y(), other.z());
    };
    std::sort(places.begin(), places.end(), order);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.empty()) {
        return {};
    }
    // The widest of the three: a wall is thin, and the next one stands beside it.
    double least = 1e-3;
    for (int axis = 0; axis < 3; ++axis) {
        const Range half = shortestHalf(sortedAlong(places, axis));
        least = std::max(least, metres[axis] * (half.second - half.first));
    }
    Aabb box;
    box.setEmpty();
    box.min() = box.max() = Vec3::Zero();
    // One axis after another, each of what the others left: else two heaps could give a box between them.
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> along = sortedAlong(places, axis);
        const Range range = grown(along, shortestHalf(along), least / metres[axis]);
        std::erase_if(places, [&](const Vec3& place) { return place[axis] < range.first || place[axis] > range.second; });
        box.min()[axis] = range.first;
        box.max()[axis] = range.second;
    }
    // Points beside those that were looked at are no far points.
    const double beyond = 0.5 * std::max(1e-3, box.sizes().cwiseProduct(metres).maxCoeff());
    const Vec3 wider = Vec3::Constant(beyond).cwiseQuotient(metres);
    return {box.min() - wider, box.max() + wider};
}

}  // namespace rubble::io
