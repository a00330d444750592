#include "core/base/sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/same_bits.h"

namespace rubble {

std::uint64_t Sequence::next() {
    m_state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double Sequence::between(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
}

std::size_t Sequence::below(std::size_t count) {
    return std::min(static_cast<std::size_t>(between(0.0, static_cast<double>(count))), count - 1);
}

Quat Sequence::turn() {
    const double u = between(0, 1), a = between(0, 2 * std::numbers::pi), b = between(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - u), s = std::sqrt(u);
    return Quat(s * cosineOf(b), r * sineOf(a), r * cosineOf(a), s * sineOf(b)).normalized();
}

Vec3 Sequence::direction() {
    const double z = between(-1, 1), a = between(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * cosineOf(a), r * sineOf(a), z};
}

}  // namespace rubble
