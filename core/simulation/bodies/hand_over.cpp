#include "core/simulation/bodies/hand_over.h"

#include <algorithm>
#include <map>

#include "core/clusters/rigid_motion.h"
#include "core/engine/world/body_shapes.h"
#include "core/simulation/bodies/cluster_shape.h"
#include "core/simulation/bodies/element_nodes.h"

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

std::vector<std::uint32_t> nodesOf(const RunDescription& description, std::span<const FragmentId> members) {
    std::vector<ElementIndex> elements;
    for (const FragmentId f : members) {
        elements.push_back(description.fragments->list[at(f)].element);
    }
    return nodesOf(description.fe->mesh(), elements);
}

/// A wire or a point is as hard to turn as the least box that its shape was thickened to: a contact off its centre would find next
/// to no mass there and sink in. Its angular momentum stays. A hull is as thick as its points are: nothing was added to it.
void fillOut(NewBody& body) {
    if (std::any_of(body.shape.begin(), body.shape.end(), [](const ConvexPart& part) { return !part.points.empty(); })) {
        return;
    }
    const double least = body.mass * body.smallestSide * body.smallestSide / 6.0;
    const Vec3 filled = body.inertia.cwiseMax(least);
    const Vec3 spin = body.pose.orientation.conjugate() * body.angularVelocity;
    body.angularVelocity = body.pose.orientation * spin.cwiseProduct(body.inertia).cwiseQuotient(filled);
    body.inertia = filled;
}

/// Nothing if it is none that the engine can take.
/// @param shapes      solids of the members; @param inShapes  their ids there
/// @param shapeFrame  where the body's frame lies among them
std::optional<NewBody> soundBody(const RunDescription& description, const Cluster& cluster, const BodyFrame& frame,
                                 std::span<const FragmentId> members, const FragmentSet& shapes,
                                 std::span<const FragmentId> inShapes, const Pose& shapeFrame) {
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
    body.shape = clusterShape(shapes, inShapes, shapeFrame, shapeOfCluster(*description.fe, scenario, members.size()),
                              scenario.simulation.boxBulking, scenario.fragments, finestBrick(description.sizing.get()));
    body.smallestSide = smallestSide(body.shape);
    fillOut(body);
    body.volume = volumeOf(description, members);
    body.material = description.components->list[at(cluster.component)].material;
    body.nodes = nodesOf(description, members);
    return sound(body.shape) ? std::optional(body) : std::nullopt;
}

std::optional<NewBody> soundBody(const RunDescription& description, const Cluster& cluster, std::span<const FragmentId> members) {
    if (!cluster.inertia.allFinite()) {
        return std::nullopt;
    }
    const BodyFrame frame = bodyFrame(cluster);
    return soundBody(description, cluster, frame, members, *description.fragments, members, frame.pose);
}

MovingMass movingMass(const Fragment& f) {
    return {f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity};
}

/// Some members of a cluster as the FE result moves them.
Cluster partOf(const RunDescription& description, ClusterId whole, std::span<const FragmentId> members) {
    std::vector<MovingMass> masses;
    std::vector<std::uint32_t> all;
    for (const FragmentId f : members) {
        all.push_back(static_cast<std::uint32_t>(masses.size()));
        masses.push_back(movingMass(description.fragments->list[at(f)]));
    }
    const MovingMass joined = joinRigidly(masses, all);
    Cluster part = description.clustering->list[at(whole)];
    part.mass = joined.mass;
    part.centre = joined.centre;
    part.inertia = joined.inertia;
    part.velocity = joined.velocity;
    part.angularVelocity = joined.angularVelocity;
    return part;
}

/// A cluster, or what one carrier has of it.
struct Entry {
    ClusterId cluster{};
    std::optional<std::int32_t> carrier;
    std::vector<FragmentId> members;
    bool part = false;
    std::optional<NewBody> body;
    Pose inFe;  ///< where the body's frame lies among the places of the FE result
};

Momenta momentaOf(const Cluster& c) {
    return rigidMomenta(c.mass, c.centre, c.inertia, c.velocity, c.angularVelocity);
}

void makeBody(Entry& entry, const RunDescription& description, const IslandBirths& islands, const RigidWorld& world) {
    const Cluster& cluster = description.clustering->list[at(entry.cluster)];
    if (!entry.carrier) {
        entry.body = entry.part ? soundBody(description, partOf(description, entry.cluster, entry.members), entry.members)
                                : bodyOf(description, entry.cluster);
        if (entry.body) {
            entry.inFe = entry.body->pose;
        }
        return;
    }
    std::optional<IslandBirth> born = islands.born(*entry.carrier, entry.members, cluster.handOverState, world);
    if (!born) {
        return;
    }
    born->cluster.component = cluster.component;
    std::vector<FragmentId> inShapes;
    for (std::size_t i = 0; i < entry.members.size(); ++i) {
        inShapes.push_back(idAt<FragmentId>(i));
    }
    entry.body = soundBody(description, born->cluster, born->frame, entry.members, born->shapes, inShapes, born->shapeFrame);
    entry.inFe = born->feFrame;
}

/// Those that the FE result moves first, for a world numbers its bodies as they come.
std::vector<Entry> entriesOf(const RunDescription& description, std::size_t first, std::size_t last, const IslandBirths& islands) {
    std::vector<Entry> fromFe, fromIslands;
    for (std::size_t c = first; c < last; ++c) {
        const ClusterId id = idAt<ClusterId>(c);
        std::map<std::optional<std::int32_t>, std::vector<FragmentId>> parts;
        for (const FragmentId fragment : description.clustering->membersOf(id)) {
            parts[islands.carrierOf(description.fragments->list[at(fragment)].element)].push_back(fragment);
        }
        for (auto& [carrier, members] : parts) {
            (carrier ? fromIslands : fromFe).push_back({id, carrier, std::move(members), parts.size() > 1, {}, {}});
        }
    }
    std::ranges::move(fromIslands, std::back_inserter(fromFe));
    return fromFe;
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

Births handOver(const RunDescription& description, std::size_t first, std::size_t last, const IslandBirths& islands,
                RigidWorld& world, Findings& findings) {
    std::vector<Entry> entries = entriesOf(description, first, last, islands);
    world.onThreads(entries.size(), entryGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            makeBody(entries[i], description, islands, world);
        }
    });
    Births births;
    for (const Entry& entry : entries) {
        if (!entry.body) {
            refuse(description, entry.cluster, findings);
            continue;
        }
        HandOver& made = entry.carrier ? births.fromIslands : births.fromFe;
        const Cluster& cluster = description.clustering->list[at(entry.cluster)];
        const BodyId entered = world.addBody(*entry.body);
        made.bodies.push_back({entered, entry.cluster, cluster.handOverTime, cluster.endTime,
                               entry.part || entry.carrier ? entry.body->mass : cluster.mass, entry.body->pose, entry.inFe,
                               entry.part});
        const Momenta together = entry.part || entry.carrier ? world.momenta(entered) : momentaOf(cluster);
        made.clusters += together;
        const Quat inverse = entry.inFe.orientation.conjugate();
        const Pose toBody{-(inverse * entry.inFe.position), inverse};
        for (const FragmentId fragment : entry.members) {
            made.carriers.push_back({fragment, entered, cluster.handOverTime, cluster.endTime, toBody});
        }
    }
    return births;
}

}  // namespace rubble
