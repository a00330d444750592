#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// Halvings of the cube that the order of points tells apart.
inline constexpr int octreeKeyLevels = 21;
/// Halvings beyond these that a place keeps: in a cube of 10 km it is exact to 5 micrometres.
inline constexpr int octreeRestLevels = 10;
/// A node holds one point in each of 64 x 64 x 64 cells.
inline constexpr int octreeCellLevels = 6;
inline constexpr int octreeDeepest = octreeKeyLevels - octreeCellLevels;

/// The bit of a key that far points have: they come after all others.
inline constexpr std::uint64_t octreeFarKey = std::uint64_t{1} << 63;

/// A point as the octree sorts it.
struct OctreePoint {
    std::uint64_t key = 0;   ///< the 21 upper bits of the steps along x, y and z, interleaved (Morton order); octreeFarKey
    std::uint32_t rest = 0;  ///< the 10 lower bits of each
    float intensity = 0.0F;
    std::array<std::uint8_t, 3> colour{};
    std::uint8_t kind = 0;  ///< class, 255 at most
};

/// Halvings that two keys share, octreeKeyLevels if they are equal.
int sharedLevels(std::uint64_t one, std::uint64_t other);

/// The cube around a cloud, equally wide in metres along each axis, in whole steps of 2^-31 of it.
class OctreeCube {
public:
    OctreeCube() = default;
    /// @param box  of the points, units of the file; not empty
    OctreeCube(const Aabb& box, const CloudUnits& units);
    OctreeCube(const Vec3& low, const Vec3& step, double side) : m_low(low), m_step(step), m_side(side) {}

    const Vec3& low() const { return m_low; }
    /// Units of the file.
    const Vec3& step() const { return m_step; }
    /// m
    double side() const { return m_side; }
    /// Puts a place into a point. @return false: it lies outside of the cube
    bool put(const Vec3& place, OctreePoint& point) const;
    std::array<std::uint32_t, 3> stepsOf(const OctreePoint& point) const;
    /// Units of the file, the middle of the step.
    Vec3 placeOf(const std::array<std::uint32_t, 3>& steps) const;
    /// The cell that the first so many halvings of a key lead to, units of the file.
    Aabb cell(std::uint64_t prefix, int level) const;

private:
    Vec3 m_low = Vec3::Zero();
    Vec3 m_step = Vec3::Ones();
    double m_side = 1.0;
};

}  // namespace rubble::io
