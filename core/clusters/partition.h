#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/clusters/axis_grouping.h"
#include "core/clusters/axis_order.h"
#include "core/clusters/nested_cuts.h"
#include "core/clusters/rigid_motion.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// Which fragments move together at one grid: members cluster by cluster.
struct Partition {
    std::vector<std::uint32_t> members;  ///< fragment indices, ascending within each cluster
    std::vector<std::uint32_t> sizes;    ///< members of each cluster
    std::size_t productGroups = 0;       ///< of the grid, before the splits
    std::size_t splitByComponent = 0;    ///< clusters added by the split
    std::size_t splitByVelocity = 0;
    std::size_t awake = 0;  ///< most clusters born within the awake time up to any birth

    std::size_t clusters() const { return sizes.size(); }
};

/// Divides the fragments of a set into clusters at any number of grids. What no grid changes (the births, the orders along the
/// axes) is made once, and the labels along an axis are kept while its size stays: a search costs little more than the axes it
/// moves. Keeps no reference to what it was made of.
class Partitioner {
public:
    Partitioner(const FragmentSet& fragments, const Mesh& mesh);

    /// Nested cuts within each component, or the product of the groups along the axes split by component; then split by velocity as
    /// the settings say. @param size  [3] m
    /// The reference stays valid until the next call. Throws Cancelled.
    const Partition& at(const std::array<double, 3>& size, const GridSettings& settings, const Execution& execution);

    /// True if at() would have no more clusters awake at once than this. Stops at the birth that exceeds them, so that the grids a
    /// search turns down cost a part of one that it takes; latest() is unspecified then. Throws Cancelled.
    bool atMost(std::size_t awake, const std::array<double, 3>& size, const GridSettings& settings, const Execution& execution);

    /// What at() gave last.
    const Partition& latest() const { return m_partition; }

    std::size_t births() const { return m_births.size(); }
    std::span<const MovingMass> masses() const { return m_masses; }

private:
    /// Fragments taken over at one state that end at one time: only these may share a cluster.
    struct Birth {
        double time = 0.0;                     ///< s, of the hand-over; never before that of the birth before it
        std::vector<std::uint32_t> fragments;  ///< ascending
        std::array<AxisOrder, 3> order;
    };
    /// Labels of all fragments along one axis at one size.
    struct AxisLabels {
        double size = -1.0;                 ///< m; negative: none yet
        std::vector<std::uint32_t> label;   ///< birth by birth [fragments]
        std::vector<std::uint32_t> groups;  ///< [births]
    };

    void countAwake(std::size_t birth, const GridSettings& settings);
    void divide(const std::array<double, 3>& size, const GridSettings& settings, std::size_t enough, const Execution& execution);
    void groupAxis(int axis, double size, const Execution& execution);
    void orderByComponent(std::span<const std::uint32_t> fragments, const GridSettings& settings);
    void divideBirth(std::size_t birth, std::size_t offset, const GridSettings& settings);
    void cutBirth(const Birth& birth, const std::array<double, 3>& size, const GridSettings& settings);
    void splitByVelocity(std::size_t firstMember, std::size_t firstSize, const GridSettings& settings);
    void sortStably(std::span<const std::uint32_t> key, std::uint32_t keys);

    std::vector<MovingMass> m_masses;        ///< [fragments]
    std::vector<std::uint32_t> m_component;  ///< [fragments]
    std::uint32_t m_components = 0;
    std::vector<Birth> m_births;
    std::vector<std::size_t> m_clustersUpTo;  ///< clusters of this birth and all before it [births divided]
    std::size_t m_firstAwake = 0;             ///< birth whose clusters are the first still awake
    std::array<AxisLabels, 3> m_axis;
    AxisGrouping m_grouping;
    NestedCuts m_cuts;
    Partition m_partition;
    std::vector<std::uint32_t> m_order;   ///< places within the birth at hand
    std::vector<std::uint32_t> m_sorted;  ///< working copy of the order
    std::vector<std::uint32_t> m_starts;  ///< counts of keys
    std::vector<std::uint32_t> m_componentOf;
};

}  // namespace rubble
