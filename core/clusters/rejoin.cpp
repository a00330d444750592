#include "core/clusters/rejoin.h"

#include <cassert>

#include "core/clusters/rigid_motion.h"

namespace rubble {

Clustering rejoinClusters(const Clustering& pattern, const FragmentSet& fragments) {
    assert(pattern.of.size() == fragments.size());
    std::vector<MovingMass> masses;
    masses.reserve(fragments.size());
    for (const Fragment& fragment : fragments.list) {
        masses.push_back({fragment.mass, fragment.centre, fragment.inertia, fragment.velocity, fragment.angularVelocity});
    }
    Clustering rejoined = pattern;
    std::vector<std::uint32_t> members;
    for (std::size_t c = 0; c < rejoined.list.size(); ++c) {
        members.clear();
        for (const FragmentId member : pattern.membersOf(idAt<ClusterId>(c))) {
            members.push_back(static_cast<std::uint32_t>(at(member)));
        }
        const MovingMass body = joinRigidly(masses, members);
        Cluster& cluster = rejoined.list[c];
        cluster.mass = body.mass;
        cluster.centre = body.centre;
        cluster.inertia = body.inertia;
        cluster.velocity = body.velocity;
        cluster.angularVelocity = body.angularVelocity;
    }
    return rejoined;
}

}  // namespace rubble
