#pragma once

#include <utility>

namespace rubble {

/// Value that the ratio of two mean squares with m and n degrees of freedom stays below with a probability p in (0, 1) (Fisher's F
/// distribution). m, n > 0.
double fisherQuantile(double p, double m, double n);

/// The regularised incomplete beta function I_x(a, b), a, b > 0, x in [0, 1].
double incompleteBeta(double a, double b, double x);

/// A number and its spread, both to the second digit of the spread: no more of them means anything. As they are where there is no
/// spread.
std::pair<double, double> roundedToSpread(double number, double spread);

}  // namespace rubble
