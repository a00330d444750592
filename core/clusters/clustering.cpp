#include "core/clusters/clustering.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/clusters/axis_grouping.h"
#include "core/clusters/body_clusters.h"
#include "core/clusters/partition.h"

namespace rubble {

namespace {

Cluster clusterOf(const FragmentSet& fragments, std::span<const MovingMass> masses, std::span<const std::uint32_t> members) {
    const Fragment& first = fragments.list[members.front()];
    const MovingMass body = joinRigidly(masses, members);
    Cluster cluster;
    cluster.memberCount = static_cast<std::uint32_t>(members.size());
    cluster.component = first.component;
    cluster.handOverState = first.handOverState;
    cluster.handOverTime = first.handOverTime;
    cluster.endTime = first.endTime;
    cluster.mass = body.mass;
    cluster.centre = body.centre;
    cluster.inertia = body.inertia;
    cluster.velocity = body.velocity;
    cluster.angularVelocity = body.angularVelocity;
    return cluster;
}

/// Clusters of a partition as spans of fragment indices, by hand-over state, then first member.
std::vector<std::span<const std::uint32_t>> inClusterOrder(const FragmentSet& fragments, const Partition& partition) {
    std::vector<std::span<const std::uint32_t>> clusters;
    std::span<const std::uint32_t> rest = partition.members;
    for (const std::uint32_t size : partition.sizes) {
        clusters.push_back(rest.first(size));
        rest = rest.subspan(size);
    }
    std::ranges::sort(clusters, [&](const auto& a, const auto& b) {
        return std::make_tuple(fragments.list[a.front()].handOverState, a.front()) <
               std::make_tuple(fragments.list[b.front()].handOverState, b.front());
    });
    return clusters;
}

void append(Clustering& clustering, const FragmentSet& fragments, std::span<const MovingMass> masses,
            std::span<const std::uint32_t> members) {
    Cluster cluster = clusterOf(fragments, masses, members);
    cluster.firstMember = static_cast<std::uint32_t>(clustering.members.size());
    for (const std::uint32_t f : members) {
        clustering.members.push_back(idAt<FragmentId>(f));
        clustering.of[f] = idAt<ClusterId>(clustering.list.size());
    }
    clustering.list.push_back(cluster);
}

}  // namespace

std::vector<std::uint32_t> groupAlongAxis(std::span<const double> low, std::span<const double> high, std::span<const double> centre,
                                          std::span<const std::int64_t> elementId, double size) {
    std::vector<std::uint32_t> group(low.size());
    AxisGrouping().group(orderAlongAxis(low, high, centre, elementId), size, group);
    return group;
}

Clustering makeClusters(const FragmentSet& fragments, const Mesh& mesh, const BasicGrid& grid, const GridSettings& settings,
                        const Execution& execution) {
    Partitioner partitioner(fragments, mesh);
    const Partition& partition = partitioner.at({grid.l, grid.w, grid.h}, settings, execution);
    Clustering clustering;
    clustering.productGroups = partition.productGroups;
    clustering.splitByComponent = partition.splitByComponent;
    clustering.splitByVelocity = partition.splitByVelocity;
    clustering.list.reserve(partition.clusters());
    clustering.members.reserve(fragments.size());
    clustering.of.resize(fragments.size());
    for (const std::span<const std::uint32_t> members : inClusterOrder(fragments, partition)) {
        append(clustering, fragments, partitioner.masses(), members);
    }
    execution.check();
    return clustering;
}

Clustering makeBodyClusters(const FragmentSet& fragments, std::span<const std::uint32_t> bodies) {
    std::vector<MovingMass> masses;
    for (const Fragment& f : fragments.list) {
        masses.push_back({f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity});
    }
    Clustering clustering;
    clustering.of.resize(fragments.size());
    std::vector<std::uint32_t> members;
    // Elements of a body follow each other and are let go together, so their fragments are neighbours in the list.
    for (std::uint32_t f = 0; f < fragments.size(); ++f) {
        members.push_back(f);
        const bool last =
            f + 1 == fragments.size() || bodies[at(fragments.list[f].element)] != bodies[at(fragments.list[f + 1].element)];
        if (last) {
            append(clustering, fragments, masses, members);
            members.clear();
        }
    }
    clustering.productGroups = clustering.list.size();
    return clustering;
}

}  // namespace rubble
