#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// Cuts sets of fragments in two, from the top down, until every part is as compact as a full box of the Basic Grid.
///
/// The spread of a part is D = sum over its fragments of m |S^-1 (x - X)|^2 plus the same of each fragment about its own centre,
/// with S = diag(l, w, h) and X the centre of mass: what is lost by letting its fragments move as one, as in a vector quantiser
/// that is grown as a tree. A full box l x w x h of mass M has D = M / 4 (1 / 12 an axis), so a part of mass m is cut while D > m
/// / 4. The cut goes across the axis along which the centres lie furthest apart in terms of the grid, where the spread of the two
/// sides together is least, so that it meets gaps.
class NestedCuts {
public:
    NestedCuts(const FragmentSet& fragments, const Mesh& mesh);

    /// Cuts one set. O(n) a level, about log n levels.
    /// @param size     [3] m, positive
    /// @param members  at least one fragment index; reordered part by part, ascending within each
    /// @param sizes    the sizes of the parts are appended
    void cut(const std::array<double, 3>& size, std::span<std::uint32_t> members, std::vector<std::uint32_t>& sizes);

private:
    struct Solid {
        Vec3 centre = Vec3::Zero();   ///< m, of mass
        Vec3 extents = Vec3::Zero();  ///< m, of its bounds
        double mass = 0.0;            ///< kg
    };
    struct Spread {
        double perMass = 0.0;  ///< D / m
        int axis = 0;          ///< along which the centres lie furthest apart in terms of the grid
    };
    /// The order of all fragments along an axis, by centre, element, index. Parts are sorted by their ranks, which are numbers side
    /// by side, where centres would have to be fetched from all over the memory.
    struct AxisRanks {
        std::vector<std::uint32_t> rank;  ///< [fragments]
        std::vector<std::uint32_t> at;    ///< fragment of each rank
    };
    Spread spreadOf(std::span<const std::uint32_t> members, const std::array<double, 3>& size) const;
    std::size_t bestCut(std::span<std::uint32_t> members, int axis);
    void sort(std::span<std::uint32_t> numbers);

    std::vector<Solid> m_solids;                   ///< [fragments]
    std::array<AxisRanks, 3> m_ranks;              ///< by axis
    std::vector<std::uint32_t> m_sorted;           ///< working copy of what is sorted
    std::vector<std::span<std::uint32_t>> m_open;  ///< parts to be looked at, the next one last
};

}  // namespace rubble
