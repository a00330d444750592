#include "core/evidence/photographs/confidence.h"

#include <cassert>
#include <cmath>

namespace rubble {

namespace {

/// The continued fraction of the incomplete beta function by Lentz's method (Abramowitz & Stegun 26.5.8).
double betaFraction(double a, double b, double x) {
    constexpr int terms = 500;
    constexpr double tiny = 1e-300;
    const auto kept = [](double value) { return std::abs(value) < tiny ? tiny : value; };
    double c = 1.0;
    double d = 1.0 / kept(1.0 - (a + b) * x / (a + 1.0));
    double fraction = d;
    for (int k = 1; k <= terms; ++k) {
        const double even = k * (b - k) * x / ((a + 2 * k - 1.0) * (a + 2 * k));
        d = 1.0 / kept(1.0 + even * d);
        c = kept(1.0 + even / c);
        fraction *= d * c;
        const double odd = -(a + k) * (a + b + k) * x / ((a + 2 * k) * (a + 2 * k + 1.0));
        d = 1.0 / kept(1.0 + odd * d);
        c = kept(1.0 + odd / c);
        fraction *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15) {
            break;
        }
    }
    return fraction;
}

}  // namespace

double incompleteBeta(double a, double b, double x) {
    assert(a > 0.0 && b > 0.0 && x >= 0.0 && x <= 1.0);
    if (x <= 0.0 || x >= 1.0) {
        return x <= 0.0 ? 0.0 : 1.0;
    }
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    // The fraction converges fast below the mean; above it the other tail is taken.
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(a, b, x) / a : 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

double fisherQuantile(double p, double m, double n) {
    assert(p > 0.0 && p < 1.0 && m > 0.0 && n > 0.0);
    double low = 0.0;
    double high = 1.0;
    constexpr int halvings = 200;
    for (int k = 0; k < halvings; ++k) {
        const double x = 0.5 * (low + high);
        (incompleteBeta(0.5 * m, 0.5 * n, x) < p ? low : high) = x;
    }
    const double x = 0.5 * (low + high);
    return n * x / (m * (1.0 - x));
}

std::pair<double, double> roundedToSpread(double number, double spread) {
    if (!(spread > 0.0) || !std::isfinite(number) || !std::isfinite(spread)) {
        return {number, spread};
    }
    const double digits = 1.0 - std::floor(std::log10(spread));
    const auto rounded = [digits](double value) {
        // A whole power divides, so that 0.1 comes out as the nearest number to it.
        const double power = std::pow(10.0, std::abs(digits));
        return digits >= 0.0 ? std::round(value * power) / power : std::round(value / power) * power;
    };
    return {rounded(number), rounded(spread)};
}

}  // namespace rubble
