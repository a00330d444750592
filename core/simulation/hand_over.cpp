#include "core/simulation/hand_over.h"

#include "core/simulation/body_shapes.h"

namespace rubble {

namespace {

bool sound(const Cluster& cluster, const BodyFrame& frame) {
    return std::isfinite(cluster.mass) && cluster.mass > 0.0 && cluster.centre.allFinite() && frame.inertia.allFinite() &&
           frame.inertia.minCoeff() > 0.0 && cluster.velocity.allFinite() && cluster.angularVelocity.allFinite();
}

bool sound(const CollisionShape& shape) {
    for (const ConvexPart& part : shape) {
        if (!part.box.centre.allFinite() || !part.box.halfExtents.allFinite() || part.box.halfExtents.minCoeff() <= 0.0) {
            return false;
        }
    }
    return !shape.empty();
}

void refuse(const RunDescription& description, ClusterId cluster, Findings& findings) {
    const Fragment& first = description.fragments->list[at(description.clustering->membersOf(cluster).front())];
    const Mesh& mesh = description.fe->mesh();
    findings.add(
        {"simulation.body_refused", "{0} bodies have no finite, positive mass, inertia, place or size and were left out", {}},
        {"simulation.body_refused.remedy", "look at the named element in the FE file; check density and coordinates", {}},
        "element " + englishInteger(mesh.elementIds[at(first.element)]) + " (" +
            description.components->list[at(first.component)].name + ")");
}

}  // namespace

std::optional<NewBody> bodyOf(const RunDescription& description, ClusterId id, Findings& findings) {
    const Cluster& cluster = description.clustering->list[at(id)];
    const Scenario& scenario = description.scenario;
    NewBody body;
    if (cluster.inertia.allFinite()) {
        const BodyFrame frame = bodyFrame(cluster);
        if (sound(cluster, frame)) {
            body.mass = cluster.mass;
            body.inertia = frame.inertia;
            body.pose = frame.pose;
            body.velocity = cluster.velocity;
            body.angularVelocity = cluster.angularVelocity;
            body.shape = clusterShape(*description.fragments, description.clustering->membersOf(id), frame.pose,
                                      scenario.simulation.shape, scenario.simulation.boxBulking, scenario.fragments);
            body.smallestSide = smallestSide(body.shape);
            if (sound(body.shape)) {
                return body;
            }
        }
    }
    refuse(description, id, findings);
    return std::nullopt;
}

HandOver handOver(const RunDescription& description, std::size_t first, std::size_t last, RigidWorld& world, Findings& findings) {
    HandOver made;
    for (std::size_t c = first; c < last; ++c) {
        const ClusterId id = idAt<ClusterId>(c);
        const std::optional<NewBody> body = bodyOf(description, id, findings);
        if (!body) {
            continue;
        }
        const Cluster& cluster = description.clustering->list[c];
        const BodyId entered = world.addBody(*body);
        made.bodies.push_back({entered, id, cluster.handOverTime, cluster.endTime, cluster.mass, body->pose});
        made.clusters.push_back(id);
        const Quat inverse = body->pose.orientation.conjugate();
        const Pose toBody{-(inverse * body->pose.position), inverse};
        for (const FragmentId fragment : description.clustering->membersOf(id)) {
            made.carriers.push_back({fragment, entered, cluster.handOverTime, cluster.endTime, toBody});
        }
    }
    return made;
}

}  // namespace rubble
