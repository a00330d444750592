#pragma once

namespace rubble {

/// Share of the standard normal distribution above x, 0 to 1, with its digits however small it is.
double normalShareAbove(double x);

/// The place that has this share of the standard normal distribution above it, to 1e-12: Abramowitz and Stegun, Handbook of
/// Mathematical Functions (1964), 26.2.23, which is off by at most 4.5e-4, and two steps of Halley's method.
/// @param share  above 0 and below 1; digits are lost where it is close to 1
double normalPlaceAbove(double share);

/// Of a standard normal distribution that is cut at two places, the place with a share of what is left below it.
/// @param low, high  in this order; zero lies between them, infinity is allowed
/// @param share      above 0 and below 1
double cutNormalPlace(double low, double high, double share);

}  // namespace rubble
