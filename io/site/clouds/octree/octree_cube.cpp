#include "io/site/clouds/octree/octree_cube.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace rubble::io {

namespace {

constexpr double steps = 2147483648.0;  // 2^31
constexpr std::uint32_t restMask = (std::uint32_t{1} << octreeRestLevels) - 1;

/// Puts two empty bits behind each of 21.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32U) & 0x1f00000000ffff;
    x = (x | x << 16U) & 0x1f0000ff0000ff;
    x = (x | x << 8U) & 0x100f00f00f00f00f;
    x = (x | x << 4U) & 0x10c30c30c30c30c3;
    return (x | x << 2U) & 0x1249249249249249;
}

std::uint32_t gather(std::uint64_t x) {
    x &= 0x1249249249249249;
    x = (x | x >> 2U) & 0x10c30c30c30c30c3;
    x = (x | x >> 4U) & 0x100f00f00f00f00f;
    x = (x | x >> 8U) & 0x1f0000ff0000ff;
    x = (x | x >> 16U) & 0x1f00000000ffff;
    return static_cast<std::uint32_t>((x | x >> 32U) & 0x1fffff);
}

/// m to each unit along x, y and z.
Vec3 metresPerUnit(const CloudUnits& units, const Aabb& box) {
    if (!units.degrees) {
        return {units.metres, units.metres, units.heightMetres};
    }
    // Good enough for cells that look like cubes: lengths are measured elsewhere.
    constexpr double perDegree = 111'000.0;
    const double parallel = std::max(0.01, std::cos(box.center().y() * std::numbers::pi / 180.0));
    return {perDegree * parallel, perDegree, units.heightMetres};
}

}  // namespace

int sharedLevels(std::uint64_t one, std::uint64_t other) {
    return one == other ? octreeKeyLevels : (std::countl_zero(one ^ other) - 1) / 3;
}

OctreeCube::OctreeCube(const Aabb& box, const CloudUnits& units) {
    const Vec3 metres = metresPerUnit(units, box);
    // A little wider: the numbers of a head may be rounded.
    constexpr double wider = 1.0 + 1e-6;
    m_side = wider * std::max(1e-3, box.sizes().cwiseProduct(metres).maxCoeff());
    const Vec3 sides = Vec3::Constant(m_side).cwiseQuotient(metres);
    m_low = box.center() - 0.5 * sides;
    m_step = sides / steps;
}

bool OctreeCube::put(const Vec3& place, OctreePoint& point) const {
    const Vec3 at = (place - m_low).cwiseQuotient(m_step);
    if (!(at.minCoeff() >= 0.0 && at.maxCoeff() < steps)) {
        return false;
    }
    point.key = 0;
    point.rest = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const auto whole = static_cast<std::uint32_t>(at[axis]);
        point.key |= spread(whole >> unsigned{octreeRestLevels}) << axis;
        point.rest |= (whole & restMask) << (unsigned{octreeRestLevels} * axis);
    }
    return true;
}

std::array<std::uint32_t, 3> OctreeCube::stepsOf(const OctreePoint& point) const {
    std::array<std::uint32_t, 3> whole{};
    for (unsigned axis = 0; axis < 3; ++axis) {
        whole[axis] = gather(point.key >> axis) << unsigned{octreeRestLevels};
        whole[axis] |= (point.rest >> (unsigned{octreeRestLevels} * axis)) & restMask;
    }
    return whole;
}

Vec3 OctreeCube::placeOf(const std::array<std::uint32_t, 3>& whole) const {
    return m_low + m_step.cwiseProduct(Vec3(whole[0] + 0.5, whole[1] + 0.5, whole[2] + 0.5));
}

Aabb OctreeCube::cell(std::uint64_t prefix, int level) const {
    const double share = std::ldexp(1.0, -level);
    const Vec3 sides = share * steps * m_step;
    const Vec3 number(gather(prefix), gather(prefix >> 1U), gather(prefix >> 2U));
    const Vec3 low = m_low + sides.cwiseProduct(number);
    return {low, low + sides};
}

}  // namespace rubble::io
