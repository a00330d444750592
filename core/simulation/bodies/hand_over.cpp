#include "core/simulation/bodies/hand_over.h"

#include "core/engine/world/body_shapes.h"

namespace rubble {

namespace {

/// Bodies that one thread makes at a time.
constexpr std::size_t entryGrain = 16;

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

/// m3, of the elements at rest.
double volumeOf(const RunDescription& description, std::span<const FragmentId> members) {
    double volume = 0.0;
    for (const FragmentId f : members) {
        volume += description.components->volume[at(description.fragments->list[at(f)].element)];
    }
    return volume;
}

/// A wire or a point is as hard to turn as the least box that its shape was thickened to: a contact off its centre would find next
/// to no mass there and sink in. Its angular momentum stays.
void fillOut(NewBody& body) {
    const double least = body.mass * body.smallestSide * body.smallestSide / 6.0;
    const Vec3 filled = body.inertia.cwiseMax(least);
    const Vec3 spin = body.pose.orientation.conjugate() * body.angularVelocity;
    body.angularVelocity = body.pose.orientation * spin.cwiseProduct(body.inertia).cwiseQuotient(filled);
    body.inertia = filled;
}

/// Nothing if it is none that the engine can take.
std::optional<NewBody> soundBody(const RunDescription& description, const Cluster& cluster, std::span<const FragmentId> members) {
    if (!cluster.inertia.allFinite()) {
        return std::nullopt;
    }
    const BodyFrame frame = bodyFrame(cluster);
    if (!sound(cluster, frame)) {
        return std::nullopt;
    }
    const Scenario& scenario = description.scenario;
    NewBody body;
    body.mass = cluster.mass;
    body.inertia = frame.inertia;
    body.pose = frame.pose;
    body.velocity = cluster.velocity;
    body.angularVelocity = cluster.angularVelocity;
    body.shape = clusterShape(*description.fragments, members, frame.pose, scenario.simulation.shape,
                              scenario.simulation.boxBulking, scenario.fragments);
    body.smallestSide = smallestSide(body.shape);
    fillOut(body);
    body.volume = volumeOf(description, members);
    body.material = description.components->list[at(cluster.component)].material;
    return sound(body.shape) ? std::optional(body) : std::nullopt;
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

std::optional<NewBody> bodyOf(const RunDescription& description, ClusterId id) {
    return soundBody(description, description.clustering->list[at(id)], description.clustering->membersOf(id));
}

std::optional<NewBody> bodyOfFragment(const RunDescription& description, FragmentId id) {
    const Fragment& fragment = description.fragments->list[at(id)];
    Cluster alone;
    alone.memberCount = 1;
    alone.component = fragment.component;
    alone.mass = fragment.mass;
    alone.centre = fragment.centre;
    alone.inertia = fragment.inertia;
    alone.velocity = fragment.velocity;
    alone.angularVelocity = fragment.angularVelocity;
    return soundBody(description, alone, {&id, 1});
}

HandOver handOver(const RunDescription& description, std::size_t first, std::size_t last, RigidWorld& world, Findings& findings) {
    std::vector<std::optional<NewBody>> bodies(last - first);
    world.onThreads(bodies.size(), entryGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            bodies[i] = bodyOf(description, idAt<ClusterId>(first + i));
        }
    });
    HandOver made;
    for (std::size_t c = first; c < last; ++c) {
        const ClusterId id = idAt<ClusterId>(c);
        const std::optional<NewBody>& body = bodies[c - first];
        if (!body) {
            refuse(description, id, findings);
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
