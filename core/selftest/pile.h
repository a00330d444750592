#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/sequence.h"
#include "core/selftest/world_scene.h"
#include "core/validation/box_overlap.h"

namespace rubble::selftest {

/// A heap of boxes in the making.
class Pile {
public:
    explicit Pile(WorldScene& scene) : m_scene(scene) {}

    BodyId add(const Vec3& centre, const Vec3& size, const Quat& turn = Quat::Identity(), const Vec3& velocity = Vec3::Zero());
    /// Boxes on a lattice, each turned at random and so far apart that none touches its neighbours.
    /// @param corner  m, lowest corner of the lattice
    void addCloud(Sequence& random, const Vec3& corner, const std::array<int, 3>& counts, const Vec3& size, double spacing);

    const std::vector<Vec3>& sizes() const { return m_sizes; }
    /// Mean height of the mass, m.
    double meanHeight() const;
    /// Root mean square of the horizontal distance of the mass from its centre, m.
    double spread() const;
    /// m3
    double volume() const;
    OverlapMeasure overlap() const { return measureOverlap(placedBoxes(m_scene.world(), m_sizes)); }
    /// Bodies whose centre lies below a height, or is not a number.
    std::int64_t centresBelow(double height) const;
    /// Largest distance of a body from where it was, m.
    double largestMove(const std::vector<Vec3>& from) const;
    std::vector<Vec3> places() const;

private:
    WorldScene& m_scene;
    std::vector<Vec3> m_sizes;
};

}  // namespace rubble::selftest
