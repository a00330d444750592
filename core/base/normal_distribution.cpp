#include "core/base/normal_distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace rubble {

double normalShareAbove(double x) {
    return 0.5 * std::erfc(x / std::numbers::sqrt2);
}

double normalPlaceAbove(double share) {
    assert(share > 0.0 && share < 1.0);
    if (share > 0.5) {
        return -normalPlaceAbove(1.0 - share);
    }
    const double t = std::sqrt(-2.0 * std::log(share));
    double x = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    for (int i = 0; i < 2; ++i) {
        const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
        const double newton = (normalShareAbove(x) - share) / density;
        x += newton / (1.0 - 0.5 * x * newton);
    }
    return x;
}

double cutNormalPlace(double low, double high, double share) {
    assert(low <= 0.0 && high >= 0.0 && share > 0.0 && share < 1.0);
    const double below = normalShareAbove(-low);
    const double above = normalShareAbove(high);
    const double left = 1.0 - below - above;
    // From the nearer end: what is close to one has lost its digits.
    const double lower = below + share * left;
    const double place = lower < 0.5 ? -normalPlaceAbove(lower) : normalPlaceAbove(above + (1.0 - share) * left);
    return std::clamp(place, low, high);
}

}  // namespace rubble
