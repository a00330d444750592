#pragma once

#include "core/base/execution.h"

namespace rubble {

/// A dry semicircular arch on two abutments that do not move.
struct VoussoirArch {
    double radius = 5.0;  ///< m, of the middle line
    int voussoirs = 31;   ///< with radial joints
    double friction = 0.8;
    double stepRate = 40.0;  ///< 1/s
};

/// The least thickness over the radius at which it stands under its own weight, half-way between one at which it does for 6 s and
/// one at which it does not, which are less than 1 % apart. Stands: no voussoir has moved by a fifth of the thickness. Throws
/// Cancelled.
double leastArchThickness(const VoussoirArch& arch, const Execution& execution);

/// The same by limit analysis: hinges at crown, haunches and springings (Milankovitch 1907; Heyman's 0.106 takes the weight to act
/// on the middle line).
constexpr double limitArchThickness = 0.1075;

}  // namespace rubble
