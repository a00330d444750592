#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// Cuts sets of fragments in two, from the top down, until every part is as compact as a full box of the Basic Grid that has the
/// proportions and the directions of the part's own fragments: what falls as one is then a larger fragment, not one of another
/// shape, and topples, slides and comes to rest as its fragments do.
///
/// With W the second moment of mass of a part's fragments, each about its own centre, and u^2 the diagonal of W of all fragments
/// scaled to |det| = 1, that box has the second moment T / 12 a unit of mass, T = G (W / det(W)^(1/3)) G, G = diag((l, w, h) / u).
/// A part whose fragments are like the mean is so compared with the box l x w x h itself; every part with a box of its volume. The
/// spread of a part is D = tr(T^-1 (B + W)), B the second moment of its fragments' masses about its centre of mass: what is lost by
/// letting its fragments move as one, as in a vector quantiser that is grown as a tree. A full box of mass M has D = M / 4 (1 / 12
/// a direction), so a part of mass m is cut while D > m / 4. Of two cuts the one that leaves the least spread on its two sides is
/// made: across the axis along which the centres lie furthest apart in terms of T, and across the direction of which that is true,
/// each where the spread along it is least, so that it meets gaps.
class NestedCuts {
public:
    NestedCuts(const FragmentSet& fragments, const Mesh& mesh);

    /// Cuts one set. O(n) a level, about log n levels.
    /// @param size     [3] m, positive
    /// @param members  at least one fragment index; reordered part by part, ascending within each
    /// @param sizes    the sizes of the parts are appended
    void cut(const std::array<double, 3>& size, std::span<std::uint32_t> members, std::vector<std::uint32_t>& sizes);

private:
    /// A second moment: xx, yy, zz, xy, xz, yz.
    using Moment = Eigen::Matrix<double, 6, 1>;
    struct Solid {
        Vec3 centre = Vec3::Zero();      ///< m, of mass
        double mass = 0.0;               ///< kg
        Moment second = Moment::Zero();  ///< kg m2, of mass about the centre
    };
    /// A part against a box of the grid.
    struct Form {
        Mat3 box = Mat3::Zero();      ///< T, m2
        Mat3 inverse = Mat3::Zero();  ///< of T
        Mat3 between = Mat3::Zero();  ///< B, kg m2
        double perMass = 0.0;         ///< D / m
    };
    /// The order of all fragments along an axis, by centre, element, index. Parts are sorted by their ranks, which are numbers side
    /// by side, where centres would have to be fetched from all over the memory.
    struct AxisRanks {
        std::vector<std::uint32_t> rank;  ///< [fragments]
        std::vector<std::uint32_t> at;    ///< fragment of each rank
    };
    Form formOf(std::span<const std::uint32_t> members, const Vec3& stretch) const;
    std::size_t cutPart(std::span<std::uint32_t> members, const Form& form);
    std::size_t bestAlong(std::span<const std::uint32_t> ordered, const Vec3& normal) const;
    double gainOf(std::span<const std::uint32_t> ordered, std::size_t first, const Mat3& inverse) const;
    void sort(std::span<std::uint32_t> numbers);
    void sortAlongAxis(std::span<std::uint32_t> members, int axis);
    void sortAlong(std::span<const std::uint32_t> members, const Vec3& normal);

    std::vector<Solid> m_solids;                            ///< [fragments]
    Vec3 m_usual = Vec3::Ones();                            ///< u
    std::array<AxisRanks, 3> m_ranks;                       ///< by axis
    std::vector<std::uint32_t> m_sorted;                    ///< working copy of what is sorted
    std::vector<std::pair<double, std::uint32_t>> m_along;  ///< places along a direction, and fragments there
    std::vector<std::span<std::uint32_t>> m_open;           ///< parts to be looked at, the next one last
};

}  // namespace rubble
