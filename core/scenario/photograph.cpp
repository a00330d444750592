#include "core/scenario/photograph.h"

#include <cmath>

namespace rubble {

bool cropped(const PhotoFacts& facts) {
    if (!facts.recorded) {
        return false;
    }
    const double here = static_cast<double>(facts.width) / facts.height;
    const double there = static_cast<double>((*facts.recorded)[0]) / (*facts.recorded)[1];
    constexpr double sameShape = 0.01;  // rounding of sizes made smaller
    return std::abs(here / there - 1.0) > sameShape;
}

std::optional<double> focalFrom(const PhotoFacts& facts) {
    // CIPA DCG-001: the equivalent keeps the diagonal of the picture, 43.27 mm on the frame.
    const double diagonal =
        cropped(facts) ? std::hypot((*facts.recorded)[0], (*facts.recorded)[1]) : std::hypot(facts.width, facts.height);
    if (!facts.focalLength35 || !(*facts.focalLength35 > 0.0) || !(diagonal > 0.0)) {
        return std::nullopt;
    }
    return *facts.focalLength35 * diagonal / std::hypot(36.0, 24.0);
}

std::string_view maskName(MaskClass kind) {
    switch (kind) {
        case MaskClass::Debris:
            return "debris";
        case MaskClass::Moved:
            return "moved";
        case MaskClass::Hidden:
            return "hidden";
        case MaskClass::NotDebris:
            break;
    }
    return "not_debris";
}

}  // namespace rubble
