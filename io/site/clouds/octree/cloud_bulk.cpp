#include "io/site/clouds/octree/cloud_bulk.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble::io {

namespace {

constexpr std::size_t bulkSample = 65'536;
constexpr double metresPerDegree = 111'000.0;
/// So many sites can each have a hundredth.
constexpr int sitesMost = 100;

using Range = std::pair<double, double>;

/// The shortest range that holds an eighth of some numbers, so that of several heaps it lies in one; of few numbers it is half.
/// @param sorted  not empty
Range densestRange(const std::vector<double>& sorted) {
    constexpr std::size_t few = 32;
    const std::size_t share = std::max(sorted.size() / 8, std::min(sorted.size() / 2, few));
    Range best(sorted[0], sorted[share]);
    for (std::size_t first = 1; first + share < sorted.size(); ++first) {
        if (sorted[first + share] - sorted[first] < best.second - best.first) {
            best = {sorted[first], sorted[first + share]};
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

/// A number that looks like chance, of the number of a point (the finish of SplitMix64).
std::uint64_t lotOf(std::uint64_t number) {
    number += 0x9e3779b97f4a7c15U;
    number = (number ^ number >> 30U) * 0xbf58476d1ce4e5b9U;
    number = (number ^ number >> 27U) * 0x94d049bb133111ebU;
    return number ^ number >> 31U;
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

Vec3 metresOf(const CloudUnits& units) {
    const double across = units.degrees ? metresPerDegree : units.metres;
    return {across, across, units.heightMetres};
}

/// m, no less than a millimetre.
double widest(const Aabb& box, const CloudUnits& units) {
    return box.isEmpty() ? 0.0 : std::max(1e-3, box.sizes().cwiseProduct(metresOf(units)).maxCoeff());
}

/// A box with so many metres more to each side; an empty one stays empty.
Aabb wider(const Aabb& box, const CloudUnits& units, double metres) {
    if (box.isEmpty()) {
        return box;
    }
    const Vec3 beyond = Vec3::Constant(metres).cwiseQuotient(metresOf(units));
    return {box.min() - beyond, box.max() + beyond};
}

/// The box about the densest of some places. @param places  different from each other, not empty; @param metres  to each unit
Aabb densest(std::vector<Vec3> places, const Vec3& metres) {
    // The widest of the three: a wall is thin, and the next one stands beside it.
    double least = 1e-3;
    for (int axis = 0; axis < 3; ++axis) {
        const Range range = densestRange(sortedAlong(places, axis));
        least = std::max(least, metres[axis] * (range.second - range.first));
    }
    Aabb box(Vec3::Zero(), Vec3::Zero());
    // One axis after another, each of what the others left: else two heaps could give a box between them.
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> along = sortedAlong(places, axis);
        const Range range = grown(along, densestRange(along), least / metres[axis]);
        std::erase_if(places, [&](const Vec3& place) { return place[axis] < range.first || place[axis] > range.second; });
        box.min()[axis] = range.first;
        box.max()[axis] = range.second;
    }
    return box;
}

}  // namespace

void CloudBulk::add(const Vec3& place) {
    const std::uint64_t lot = lotOf(m_seen++);
    while (lot % m_every == 0 && m_drawn.size() == bulkSample) {
        m_every *= 2;
        std::erase_if(m_drawn, [&](const Drawn& drawn) { return drawn.lot % m_every != 0; });
    }
    if (lot % m_every == 0) {
        m_drawn.push_back({lot, place});
    }
}

Aabb CloudBulk::box(const CloudUnits& units, const Execution& execution) const {
    // Points beside those that were looked at are no far points.
    const Bulk bulk = find(units, execution);
    return wider(bulk.all, units, 0.5 * widest(bulk.all, units));
}

Aabb CloudBulk::reach(const CloudUnits& units, const Execution& execution) const {
    const Bulk bulk = find(units, execution);
    return wider(bulk.sites, units, farTimes * bulk.width);
}

CloudBulk::Bulk CloudBulk::find(const CloudUnits& units, const Execution& execution) const {
    std::vector<Vec3> places;
    places.reserve(m_drawn.size());
    for (const Drawn& drawn : m_drawn) {
        places.push_back(drawn.place);
    }
    const auto order = [](const Vec3& one, const Vec3& other) {
        return std::tuple(one.x(), one.y(), one.z()) < std::tuple(other.x(), other.y(), other.z());
    };
    std::sort(places.begin(), places.end(), order);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto dense = static_cast<std::size_t>(std::max(denseLeast, denseShare * static_cast<double>(places.size())));
    Bulk bulk;
    bulk.sites.setEmpty();
    bulk.all.setEmpty();
    // Two sites are no strays of each other, however far they lie apart.
    // Each round costs a sort of what is left, and noise may give hardly anything to one.
    for (int round = 0; round < sitesMost && (round == 0 ? !places.empty() : places.size() >= dense); ++round) {
        execution.check();
        const Aabb site = densest(places, metresOf(units));
        const double width = widest(site, units);
        const Aabb reach = wider(site, units, farTimes * width);
        Aabb near;
        near.setEmpty();
        const std::size_t taken = std::erase_if(places, [&](const Vec3& place) {
            if (reach.contains(place)) {
                near.extend(place);
                return true;
            }
            return false;
        });
        if (round == 0 || (taken >= dense && widest(bulk.sites.merged(site), units) <= bulkWidthMost)) {
            bulk.sites.extend(site);
            bulk.all.extend(near);
            bulk.width = std::max(bulk.width, width);
        }
    }
    return bulk;
}

}  // namespace rubble::io
