#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace rubble {

/// Numbers that look random and are the same with every standard library: its generators repeat, its distributions need not.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_generator(seed) {}
    double between(double low, double high) { return low + (high - low) * static_cast<double>(m_generator() >> 11) * 0x1p-53; }
    /// Normal, of mean 0 and deviation 1 (Box & Muller 1958).
    double normal() {
        const double u = between(1e-12, 1.0);
        return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * between(0.0, 1.0));
    }

private:
    std::mt19937_64 m_generator;
};

}  // namespace rubble
