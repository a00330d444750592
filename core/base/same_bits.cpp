#include "core/base/same_bits.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rubble {

namespace {

/// A number in doubled precision: the sum of the two, the second at most half a unit in the last place of the first.
struct Doubled {
    double high = 0.0;
    double low = 0.0;
};

Doubled sumOf(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
/// The same where the second is the smaller.
Doubled settled(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
Doubled productOf(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}
Doubled plus(const Doubled& a, const Doubled& b) {
    const Doubled sum = sumOf(a.high, b.high);
    return settled(sum.high, sum.low + (a.low + b.low));
}
Doubled times(const Doubled& a, const Doubled& b) {
    const Doubled product = productOf(a.high, b.high);
    return settled(product.high, product.low + (a.high * b.low + a.low * b.high));
}
Doubled over(const Doubled& a, double b) {
    const double quotient = a.high / b;
    return settled(quotient, (std::fma(-quotient, b, a.high) + a.low) / b);
}
Doubled negative(const Doubled& a) {
    return {-a.high, -a.low};
}

constexpr std::size_t terms = 14;

/// Taylor's series in the square of the angle: of the cosine, and of the sine over the angle.
struct Series {
    std::array<Doubled, terms> sine, cosine;
    Series() {
        sine[0] = cosine[0] = {1.0, 0.0};
        for (std::size_t n = 1; n < terms; ++n) {
            const double twice = 2.0 * static_cast<double>(n);
            cosine[n] = negative(over(cosine[n - 1], twice * (twice - 1.0)));
            sine[n] = negative(over(sine[n - 1], twice * (twice + 1.0)));
        }
    }
};

Doubled sumOf(const std::array<Doubled, terms>& series, const Doubled& square) {
    Doubled sum = series.back();
    for (std::size_t n = terms - 1; n-- > 0;) {
        sum = plus(times(sum, square), series[n]);
    }
    return sum;
}

struct SineAndCosine {
    Doubled sine, cosine;
};

SineAndCosine sineAndCosine(const Doubled& x) {
    static const Series series;
    // A quarter turn to 160 bits, in three parts (Cody & Waite 1980).
    constexpr double quarter = 1.5707963267948966, quarterNext = 6.123233995736766e-17, quarterLast = -1.4973849048591833e-33;
    const double quarters = std::floor(x.high / quarter + 0.5);
    Doubled rest = plus(x, negative(productOf(quarters, quarter)));
    rest = plus(rest, negative(productOf(quarters, quarterNext)));
    rest = plus(rest, {-quarters * quarterLast, 0.0});
    const Doubled square = times(rest, rest);
    Doubled sine = times(rest, sumOf(series.sine, square));
    Doubled cosine = sumOf(series.cosine, square);
    const double turned = quarters - 4.0 * std::floor(0.25 * quarters);
    if (turned == 1.0 || turned == 3.0) {
        std::swap(sine, cosine);
        cosine = negative(cosine);
    }
    return turned >= 2.0 ? SineAndCosine{negative(sine), negative(cosine)} : SineAndCosine{sine, cosine};
}

}  // namespace

double sineOf(double x) {
    return x == 0.0 ? x : sineAndCosine({x, 0.0}).sine.high;
}

double cosineOf(double x) {
    return sineAndCosine({x, 0.0}).cosine.high;
}

double arcCosineOf(double x) {
    if (x >= 1.0) {
        return 0.0;
    }
    if (x <= -1.0) {
        return std::numbers::pi;
    }
    // Abramowitz & Stegun 4.4.45, to 7e-5, then Newton.
    const double size = std::abs(x);
    const double start = std::sqrt(1.0 - size) * (1.5707288 + size * (-0.2121144 + size * (0.0742610 - 0.0187293 * size)));
    Doubled angle{x < 0.0 ? std::numbers::pi - start : start, 0.0};
    for (int i = 0; i < 3; ++i) {
        const SineAndCosine at = sineAndCosine(angle);
        angle = plus(angle, over(plus(at.cosine, {-x, 0.0}), at.sine.high));
    }
    return angle.high;
}

double cubeRootOf(double x) {
    if (x == 0.0 || !std::isfinite(x)) {
        return x;
    }
    int exponent = 0;
    double share = std::frexp(std::abs(x), &exponent);
    const int third = (exponent >= 0 ? exponent : exponent - 2) / 3;
    share = std::ldexp(share, exponent - 3 * third);
    double root = 0.75 + 0.25 * share;  // within a tenth, then Halley's iteration
    for (int i = 0; i < 3; ++i) {
        const double cube = root * root * root;
        root = root * (cube + 2.0 * share) / (2.0 * cube + share);
    }
    const Doubled cube = times(productOf(root, root), {root, 0.0});
    root += plus({share, 0.0}, negative(cube)).high / (3.0 * root * root);
    return std::copysign(std::ldexp(root, third), x);
}

double lengthOf(double x, double y) {
    const Doubled square = plus(productOf(x, x), productOf(y, y));
    const double root = std::sqrt(square.high);
    if (!(root > 0.0) || !std::isfinite(root)) {
        return root;
    }
    return root + plus(square, negative(productOf(root, root))).high / (2.0 * root);
}

double powerOfTen(double x) {
    // In powers of two, and e to the rest.
    constexpr Doubled tens{2.302585092994046, -2.1707562233822494e-16};
    constexpr double two = 0.6931471805599453, twoNext = 2.3190468138462996e-17, twoLast = 5.707708438416212e-34;
    const Doubled exponent = times(productOf(x, 1.0), tens);
    const double twos = std::floor(exponent.high / two + 0.5);
    Doubled rest = plus(exponent, negative(productOf(twos, two)));
    rest = plus(rest, negative(productOf(twos, twoNext)));
    rest = plus(rest, {-twos * twoLast, 0.0});
    Doubled sum{1.0, 0.0};
    for (int n = 27; n > 0; --n) {
        sum = plus({1.0, 0.0}, over(times(sum, rest), n));
    }
    return std::ldexp(sum.high, static_cast<int>(twos));
}

Quat turnAbout(const Vec3& axis, double angle) {
    const double half = 0.5 * angle, sine = sineOf(half);
    return Quat(cosineOf(half), sine * axis.x(), sine * axis.y(), sine * axis.z());
}

Mat3 axesTurned(const Vec3& axis, double angle) {
    const double cosine = cosineOf(angle);
    const Vec3 side = sineOf(angle) * axis, rest = (1.0 - cosine) * axis;
    Mat3 axes;
    axes << rest.x() * axis.x() + cosine, rest.x() * axis.y() - side.z(), rest.x() * axis.z() + side.y(),
        rest.x() * axis.y() + side.z(), rest.y() * axis.y() + cosine, rest.y() * axis.z() - side.x(),
        rest.x() * axis.z() - side.y(), rest.y() * axis.z() + side.x(), rest.z() * axis.z() + cosine;
    return axes;
}

Quat turnBetween(const Quat& from, double share, const Quat& to) {
    const double same = from.dot(to);
    double first = 1.0 - share, second = share;
    if (std::abs(same) < 1.0 - std::numeric_limits<double>::epsilon()) {
        const double angle = arcCosineOf(std::abs(same)), whole = sineOf(angle);
        first = sineOf((1.0 - share) * angle) / whole;
        second = sineOf(share * angle) / whole;
    }
    return Quat(first * from.coeffs() + (same < 0.0 ? -second : second) * to.coeffs());
}

}  // namespace rubble
