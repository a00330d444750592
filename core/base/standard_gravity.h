#pragma once

namespace rubble {

/// m/s2. ISO 80000-3, after the third CGPM (1901).
inline constexpr double standardGravity = 9.80665;

}  // namespace rubble
