#pragma once

#include <limits>

namespace rubble {

/// A figure that was not measured, not given, or has no value where it stands. Differs from itself: ask with std::isnan.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace rubble
