#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace rubble {

/// Numbers that look random and are the same on every machine (SplitMix64; Steele, Lea & Flood 2014).
class Sequence {
public:
    explicit Sequence(std::uint64_t seed) : m_state(seed) {}
    double between(double low, double high);
    /// One of [0, count).
    std::size_t below(std::size_t count);
    /// Evenly over all rotations (Shoemake 1992).
    Quat turn();
    /// Evenly over all directions.
    Vec3 direction();

private:
    std::uint64_t next();
    std::uint64_t m_state;
};

}  // namespace rubble
