#include "core/evidence/maps/map_cell.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {

namespace {

constexpr double largestSide = 0.25;      // m
constexpr double cellsAlongMost = 2.0e4;  // of the structure

/// The next of 1, 2.5 and 5 times a power of ten, downwards or upwards.
double steppedSide(double side, bool upwards) {
    const double power = std::pow(10.0, std::floor(std::log10(side) + 1e-9));
    double below = power;
    for (const double factor : {1.0, 2.5, 5.0, 10.0}) {
        if (factor * power >= side * (1.0 - 1e-9)) {
            const bool same = factor * power <= side * (1.0 + 1e-9);
            return upwards || same ? factor * power : below;
        }
        below = factor * power;
    }
    return 10.0 * power;
}

double medianSize(const FragmentSet& fragments) {
    std::vector<double> sizes;
    for (const Fragment& fragment : fragments.list) {
        const double size = std::cbrt(8.0 * fragment.box.halfExtents.prod());
        if (std::isfinite(size) && size > 0.0) {
            sizes.push_back(size);
        }
    }
    if (sizes.empty()) {
        return 0.0;
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

}  // namespace

UsualCell usualMapCell(const FragmentSet& fragments, double length) {
    UsualCell usual{largestSide, medianSize(fragments)};
    if (usual.fragment > 0.0 && usual.fragment < largestSide) {
        usual.side = steppedSide(usual.fragment, false);
    }
    if (std::isfinite(length) && length / cellsAlongMost > usual.side) {
        usual.side = steppedSide(length / cellsAlongMost, true);
    }
    return usual;
}

}  // namespace rubble
