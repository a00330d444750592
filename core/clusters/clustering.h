#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/clusters/basic_grid.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// Groups along one axis (DESIGN.md 2.3) of intervals given by near face, far face and centre, with the element number to break
/// ties.
/// @param low, high, centre  [n] m
/// @param order key for full ties: elementId [n]
/// @return group of each interval [n], numbered in the order in which the greedy choice takes them
/// O(n log n) unless fragments are wider than `size` (see AxisGrouping); gives the same groups as the plain matrix version. An
/// interval wider than `size` is in a group with others only if a row takes it in or it takes in narrower ones.
std::vector<std::uint32_t> groupAlongAxis(std::span<const double> low, std::span<const double> high, std::span<const double> centre,
                                          std::span<const std::int64_t> elementId, double size);

/// One cluster: the fragments that one rigid body carries.
struct Cluster {
    std::uint32_t firstMember = 0;  ///< into Clustering::members
    std::uint32_t memberCount = 0;
    ComponentId component{};  ///< of its first member
    std::uint32_t handOverState = 0;
    double handOverTime = 0.0;    ///< s
    double endTime = 0.0;         ///< s, infinity unless its elements come back to life
    double mass = 0.0;            ///< kg
    Vec3 centre = Vec3::Zero();   ///< m, centre of mass
    Mat3 inertia = Mat3::Zero();  ///< kg m2 about the centre, world axes
    Vec3 velocity = Vec3::Zero();
    Vec3 angularVelocity = Vec3::Zero();  ///< rad/s, conserves angular momentum
};

/// Every fragment in exactly one cluster. Clusters in ClusterId order: hand-over state, then first member.
struct Clustering {
    std::vector<Cluster> list;
    std::vector<FragmentId> members;   ///< ascending within each cluster
    std::vector<ClusterId> of;         ///< cluster of each fragment [fragments]
    std::size_t productGroups = 0;     ///< before the splits
    std::size_t splitByComponent = 0;  ///< clusters added by the split
    std::size_t splitByVelocity = 0;
    Findings findings;

    std::span<const FragmentId> membersOf(ClusterId c) const {
        return {members.data() + list[at(c)].firstMember, list[at(c)].memberCount};
    }
};

/// Among the fragments of one birth (taken over at one state, ending at one time): settings.grouping nested cuts those of each
/// component, or all with settings.acrossComponents, until they are compact (NestedCuts); axes joins those with the same groups
/// along all three axes and splits by component, unless settings.acrossComponents. Then both split by velocity (splitByVelocity()).
/// Every fragment is in exactly one cluster; mass, momentum and angular momentum are those of the members to rounding. With
/// settings.oneBodyPerFragment the grid is not read. Throws Cancelled.
Clustering makeClusters(const FragmentSet& fragments, const Mesh& mesh, const BasicGrid& grid, const GridSettings& settings,
                        const Execution& execution);

}  // namespace rubble
