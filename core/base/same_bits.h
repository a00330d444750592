#pragma once

#include "core/base/geometry.h"

namespace rubble {

// What the standard library may round one way here and another way there: it has variants by processor, and every library its own.
// These take only operations that IEEE 754 rounds alike everywhere, in a fixed order, in doubled precision: the same bits on every
// machine, and the correctly rounded number but in one of some ten million cases.

/// @param x  rad; beyond 1e6 digits are lost, alike everywhere
double sineOf(double x);
double cosineOf(double x);
/// rad, in [0, pi]; of what lies beyond +-1 that of the end.
double arcCosineOf(double x);
double cubeRootOf(double x);
/// sqrt(x x + y y); overflows where a square does.
double lengthOf(double x, double y);

/// 10^x, for x within +-300.
double powerOfTen(double x);

/// A turn by an angle [rad] about a unit axis, right-handed.
Quat turnAbout(const Vec3& axis, double angle);
/// The same as a matrix.
Mat3 axesTurned(const Vec3& axis, double angle);
/// The turn that lies a share of the shorter way from one to the other.
Quat turnBetween(const Quat& from, double share, const Quat& to);

}  // namespace rubble
