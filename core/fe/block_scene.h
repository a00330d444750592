#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/fe/fe_result.h"

namespace rubble::blocks {

/// A regular block of hexahedra that becomes one part of a scene.
struct Block {
    std::string name = "block";
    Vec3 low = Vec3::Zero();   ///< m
    Vec3 size = Vec3::Ones();  ///< m
    std::array<int, 3> cells{1, 1, 1};
    double density = 2000.0;       ///< kg/m3; NaN: the file does not say
    Vec3 velocity = Vec3::Zero();  ///< m/s at t = 0
    double gravity = 0.0;          ///< m/s2, downwards, of its prescribed flight
    /// State at which each of its elements is first inactive, by index within the block; `never` for those that live.
    std::function<std::size_t(std::size_t)> deathState = [](std::size_t) { return std::numeric_limits<std::size_t>::max(); };
};
inline constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

/// An FE result in memory: blocks that move as prescribed, states at equal steps from t = 0.
/// @param withVelocity  whether the states carry nodal velocities (else they must come from differences)
std::shared_ptr<const FeResult> makeScene(const std::vector<Block>& blocks, std::size_t states, double interval,
                                          bool withVelocity = true);

}  // namespace rubble::blocks
