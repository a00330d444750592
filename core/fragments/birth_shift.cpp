#include "core/fragments/birth_shift.h"

#include <cmath>

namespace rubble {

namespace {

/// Finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the input reaches every bit of the output.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;

}  // namespace

Vec3 birthShift(double length, std::int64_t seed, std::int64_t elementNumber) {
    const std::uint64_t stream =
        mixed(static_cast<std::uint64_t>(elementNumber) + golden * mixed(static_cast<std::uint64_t>(seed)));
    // Points of a cube until one lies in the ball: only sums, products and a root, which all machines round alike.
    for (std::uint64_t counter = 1;; counter += 3) {
        Vec3 point;
        for (std::uint64_t i = 0; i < 3; ++i) {
            point[static_cast<int>(i)] = static_cast<double>(mixed(stream + golden * (counter + i)) >> 11) * 0x1.0p-52 - 1.0;
        }
        const double square = point.squaredNorm();
        if (square > 1e-4 && square <= 1.0) {
            return point * (length / std::sqrt(square));
        }
    }
}

}  // namespace rubble
