#include "core/simulation/run/carried_islands.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "core/clusters/rigid_motion.h"
#include "core/engine/world/body_shapes.h"
#include "core/fragments/solids.h"
#include "core/simulation/health/ledger.h"
#include "core/simulation/health/value_archive.h"
#include "core/simulation/run/islands.h"

namespace rubble {

namespace {

/// m/s. What moves no faster has come to rest: half of what counts as moving in an FE result.
constexpr double restingSpeed = 0.05;

/// The rigid motion that brings points nearest to others, by least squares; nothing if one of them is no number.
std::optional<Pose> motionBetween(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        a += from[i];
        b += to[i];
    }
    a /= static_cast<double>(from.size());
    b /= static_cast<double>(from.size());
    Mat3 covariance = Mat3::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        covariance += (to[i] - b) * (from[i] - a).transpose();
    }
    if (!covariance.allFinite() || !a.allFinite() || !b.allFinite()) {
        return std::nullopt;
    }
    const Quat turn = Quat(nearestRotation(covariance)).normalized();
    return Pose{b - turn * a, turn};
}

/// What errors of momenta are relative to: sums over bodies of m |v| and |x| m |v|.
struct MotionScale {
    double linear = 0.0;
    double angular = 0.0;

    void add(double mass, const Vec3& place, const Vec3& velocity) {
        linear += mass * velocity.norm();
        angular += place.norm() * mass * velocity.norm();
    }
};

void raise(double& most, double error) {
    most = std::max(most, error);
}

/// Solids of elements as a set of fragments: as much of them as a collision shape is made of.
FragmentSet solidsOf(const std::vector<IslandElement>& elements) {
    FragmentSet set;
    set.vertexOffsets.push_back(0);
    for (const IslandElement& element : elements) {
        set.list.emplace_back().box = element.box;
        set.solid.push_back(element.solid);
        set.vertices.insert(set.vertices.end(), element.vertices.begin(), element.vertices.end());
        set.vertexOffsets.push_back(static_cast<std::uint32_t>(set.vertices.size()));
    }
    return set;
}

/// What a body of an island is to a new one that leaves it: mass properties by the elements, motion by the island.
struct Departure {
    MovingMass joined;  ///< at the places of the island's state
    BodyFrame frame;
};

std::optional<Departure> departureOf(const std::vector<IslandElement>& elements) {
    std::vector<MovingMass> masses;
    std::vector<std::uint32_t> all;
    for (const IslandElement& element : elements) {
        if (element.motion.mass > 0.0) {
            all.push_back(static_cast<std::uint32_t>(masses.size()));
            masses.push_back(element.motion);
        }
    }
    if (masses.empty()) {
        return std::nullopt;
    }
    const MovingMass joined = joinRigidly(masses, all);
    if (!joined.inertia.allFinite()) {
        return std::nullopt;
    }
    return Departure{joined, bodyFrame(joined.centre, joined.inertia)};
}

/// Elements of an island in the order that is asked for.
std::vector<IslandElement> elementsOf(const IslandBody& island, std::span<const ElementIndex> wanted) {
    std::vector<IslandElement> found;
    for (const ElementIndex e : wanted) {
        const auto place = std::lower_bound(island.elements.begin(), island.elements.end(), e);
        found.push_back(island.parts[static_cast<std::size_t>(place - island.elements.begin())]);
    }
    return found;
}

Vec3 velocityAt(const BodyMotion& motion, const Vec3& place) {
    return motion.velocity + motion.angularVelocity.cross(place - motion.pose.position);
}

/// m/s, of the corners of an element.
Vec3 meanVelocity(const Mesh& mesh, ElementIndex element, const NodeState& nodes) {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t node : mesh.cornersOf(element)) {
        sum += nodes.velocity(node);
    }
    return sum / static_cast<double>(mesh.cornersOf(element).size());
}

}  // namespace

CarriedIslands::CarriedIslands(const RunDescription& description, const Activity& activity, const SiteSurface& ground)
    : m_description(description), m_activity(activity), m_ground(ground) {}

void CarriedIslands::begin(const Execution& execution) {
    if (m_loose) {
        return;
    }
    m_loose = looseStructure(*m_description.fe, m_activity, m_ground, execution);
    if (m_carrier.empty()) {
        m_carrier.assign(m_description.fe->mesh().elementCount(), -1);
        m_gone.assign(m_description.fe->mesh().elementCount(), false);
    }
}

std::optional<std::int32_t> CarriedIslands::carrierOf(ElementIndex element) const {
    if (!carries(element)) {
        return std::nullopt;
    }
    return m_carrier[at(element)];
}

std::optional<IslandBirth> CarriedIslands::born(std::int32_t carrier, std::span<const FragmentId> members, std::size_t state,
                                                const RigidWorld& world) const {
    const Body& from = m_bodies[static_cast<std::size_t>(carrier)];
    if (world.state(from.id) == BodyState::Removed) {
        return std::nullopt;
    }
    const Mesh& mesh = m_description.fe->mesh();
    const auto then = m_description.fe->state(from.state);
    const auto now = m_description.fe->state(state);
    std::vector<ElementIndex> elements;
    std::vector<Vec3> placesThen, placesNow;
    for (const FragmentId f : members) {
        elements.push_back(m_description.fragments->list[at(f)].element);
        for (const std::uint32_t node : mesh.cornersOf(elements.back())) {
            placesThen.push_back(then->positions[node]);
            placesNow.push_back(now->positions[node]);
        }
    }
    const std::vector<IslandElement> leaving = elementsOf(from.island, elements);
    const std::optional<Departure> departure = departureOf(leaving);
    const std::optional<Pose> inFe = motionBetween(placesThen, placesNow);
    if (!departure || !inFe) {
        return std::nullopt;
    }
    const BodyMotion motion = world.motion(from.id);
    const Pose carried = motion.pose * from.island.pose.inverse();
    const Pose& frame = departure->frame.pose;
    IslandBirth born;
    born.shapes = solidsOf(leaving);
    born.shapeFrame = frame;
    born.feFrame = *inFe * frame;
    born.frame = {carried * frame, departure->frame.inertia};
    const Mat3 axes = born.frame.pose.orientation.toRotationMatrix();
    born.cluster.memberCount = static_cast<std::uint32_t>(members.size());
    born.cluster.mass = departure->joined.mass;
    born.cluster.centre = born.frame.pose.position;
    born.cluster.inertia = axes * departure->frame.inertia.asDiagonal() * axes.transpose();
    born.cluster.velocity = velocityAt(motion, born.cluster.centre);
    born.cluster.angularVelocity = motion.angularVelocity;
    return born;
}

/// s, when one of the elements dies, and the body with it; infinity where none does before the FE result ends.
double CarriedIslands::endOf(const std::vector<ElementIndex>& elements, std::size_t k) const {
    const std::vector<double>& times = m_description.fe->times();
    for (std::size_t next = k + 1; next + 1 < times.size(); ++next) {
        if (std::ranges::any_of(elements, [&](ElementIndex e) { return !m_activity.active(next + 1, e); })) {
            return times[next];
        }
    }
    return std::numeric_limits<double>::infinity();
}

void CarriedIslands::enter(Body body, const NewBody& made, std::size_t k, RigidWorld& world, Change& change) {
    NewBody loose = made;
    loose.loose = true;
    body.id = world.addBody(loose);
    BodyRecord record;
    record.body = body.id;
    record.cluster = noCluster;
    record.from = m_description.fe->times()[k];
    record.to = endOf(body.island.elements, k);
    record.mass = made.mass;
    record.atBirth = made.pose;
    record.inFe = body.island.pose;
    change.bodies.push_back(record);
    change.islands.push_back({body.id, body.state, body.island.pose, body.island.elements});
    for (const ElementIndex e : body.island.elements) {
        m_carrier[at(e)] = static_cast<std::int32_t>(m_bodies.size());
        m_gone[at(e)] = true;
    }
    ++m_account.bodies;
    m_bodies.push_back(std::move(body));
}

void CarriedIslands::goOn(std::size_t before, const std::vector<ElementIndex>& left, std::size_t k, RigidWorld& world,
                          Change& change) {
    Body after;
    after.state = m_bodies[before].state;
    after.island.elements = left;
    after.island.parts = elementsOf(m_bodies[before].island, left);
    if (!giveBody(after.island, m_description)) {
        // Without mass, or none to turn: nothing that an engine could move.
        return;
    }
    const BodyMotion motion = world.motion(m_bodies[before].id);
    const Pose carried = motion.pose * m_bodies[before].island.pose.inverse();
    NewBody body = newBody(after.island, m_description);
    body.pose = carried * after.island.pose;
    body.velocity = velocityAt(motion, body.pose.position);
    body.angularVelocity = motion.angularVelocity;
    enter(std::move(after), body, k, world, change);
    change.loss->left += world.momenta(m_bodies.back().id);
}

/// Follows what is carried through the FE states, in the FE result and in the engine.
void CarriedIslands::noteBlows(std::size_t k, const RigidWorld& world) {
    if (k == 0 || m_bodies.empty()) {
        return;
    }
    const FeResult& fe = *m_description.fe;
    const NodeState nodes(fe, k);
    const Vec3 fall(0, 0, -m_description.scenario.simulation.gravity * (fe.times()[k] - fe.times()[k - 1]));
    for (const Body& body : m_bodies) {
        if (!body.there || world.state(body.id) == BodyState::Removed) {
            continue;
        }
        const BodyMotion motion = world.motion(body.id);
        const Pose carried = motion.pose * body.island.pose.inverse();
        for (const IslandElement& part : body.island.parts) {
            m_blows.advance(part.element, meanVelocity(fe.mesh(), part.element, nodes),
                            velocityAt(motion, carried * part.box.centre), fall);
        }
    }
}

void CarriedIslands::countBirths(const HandOver& born, const RigidWorld& world) {
    for (const Carrier& carrier : born.carriers) {
        const Fragment& fragment = m_description.fragments->list[at(carrier.fragment)];
        const Body& from = m_bodies[static_cast<std::size_t>(m_carrier[at(fragment.element)])];
        ++m_account.born;
        m_account.bornMass += fragment.mass;
        const BodyMotion motion = world.motion(from.id);
        if (world.state(from.id) == BodyState::Frozen || motion.velocity.norm() < restingSpeed) {
            m_account.bornAtRestMass += fragment.mass;
        }
        if (m_blows.softer(fragment.element)) {
            m_account.bornSofterMass += fragment.mass;
        }
    }
}

void CarriedIslands::lose(std::size_t k, const HandOver& born, RigidWorld& world, Change& change) {
    countBirths(born, world);
    change.loss = IslandLoss{m_description.fe->times()[k], static_cast<std::uint32_t>(k), {}, {}, {}};
    MotionScale scale;
    const std::size_t count = m_bodies.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!m_bodies[i].there) {
            continue;
        }
        if (world.state(m_bodies[i].id) == BodyState::Removed) {
            m_bodies[i].there = false;
            continue;
        }
        std::vector<ElementIndex> left;
        std::ranges::copy_if(m_bodies[i].island.elements, std::back_inserter(left),
                             [&](ElementIndex e) { return m_activity.active(k + 1, e); });
        if (left.size() == m_bodies[i].island.elements.size()) {
            continue;
        }
        const Momenta before = world.momenta(m_bodies[i].id);
        const BodyMotion motion = world.motion(m_bodies[i].id);
        change.loss->before += before;
        scale.add(before.mass, motion.pose.position, motion.velocity);
        for (const ElementIndex e : m_bodies[i].island.elements) {
            m_carrier[at(e)] = -1;
        }
        for (const std::vector<ElementIndex>& part : partsOf(m_description.fe->mesh(), left)) {
            goOn(i, part, k, world, change);
        }
        change.ended.push_back(m_bodies[i].id);
        m_bodies[i].there = false;
        m_bodies[i].island = {};
    }
    if (change.ended.empty()) {
        change.loss.reset();
        return;
    }
    for (const BodyRecord& body : born.bodies) {
        change.loss->born += world.momenta(body.body);
    }
    const IslandLoss& loss = *change.loss;
    LedgerErrors& errors = m_account.losses;
    raise(errors.bodyMass, relativeError(std::abs(loss.born.mass + loss.left.mass - loss.before.mass), loss.before.mass));
    raise(errors.bodyMomentum, relativeError((loss.born.linear + loss.left.linear - loss.before.linear).norm(), scale.linear));
    raise(errors.bodyAngularMomentum,
          relativeError((loss.born.angular + loss.left.angular - loss.before.angular).norm(), scale.angular));
}

/// What is loose at a state, lives on and is not carried yet; what dies here may part it.
std::vector<LiveIsland> CarriedIslands::toTake(std::size_t k) const {
    std::map<std::uint32_t, std::vector<ElementIndex>> fresh;
    for (const LooseStructure::Member& member : m_loose->members[k]) {
        if (!m_gone[at(member.element)] && m_activity.active(k + 1, member.element)) {
            fresh[member.island].push_back(member.element);
        }
    }
    std::vector<LiveIsland> islands;
    for (const auto& [number, elements] : fresh) {
        for (std::vector<ElementIndex>& part : partsOf(m_description.fe->mesh(), elements)) {
            islands.push_back({std::move(part), false});
        }
    }
    return islands;
}

void CarriedIslands::take(std::size_t k, RigidWorld& world, Pieces& pieces, Change& change, Findings& findings) {
    const std::vector<LiveIsland> islands = toTake(k);
    if (islands.empty()) {
        return;
    }
    change.ledger.time = m_description.fe->times()[k];
    change.ledger.state = static_cast<std::uint32_t>(k);
    MotionScale scale;
    IslandMaker maker(m_description, m_activity, islands, k);
    const NodeState nodes(*m_description.fe, k);
    for (const LiveIsland& island : islands) {
        std::optional<IslandBody> made = maker.make(island, findings);
        if (!made) {
            ++m_account.refused;
            continue;
        }
        const MovingMass m = made->motion;
        ++m_account.islands;
        m_account.elements += static_cast<std::int64_t>(island.elements.size());
        m_account.mass += m.mass;
        scale.add(m.mass, m.centre, m.velocity);
        change.ledger.fe += made->fe;
        change.ledger.fragments += made->rigid;
        change.ledger.clusters += rigidMomenta(m.mass, m.centre, m.inertia, m.velocity, m.angularVelocity);
        Body body;
        body.state = static_cast<std::uint32_t>(k);
        body.island = std::move(*made);
        const NewBody entering = newBody(body.island, m_description);
        for (const ElementIndex e : body.island.elements) {
            m_blows.begin(e, meanVelocity(m_description.fe->mesh(), e, nodes));
        }
        enter(std::move(body), entering, k, world, change);
        change.ledger.bodies += world.momenta(m_bodies.back().id);
    }
    pieces.release(world, m_gone, k);
    LedgerRow& row = change.ledger;
    row.droppedKineticEnergy = row.fe.kineticEnergy - row.bodies.kineticEnergy;
    m_account.droppedKineticEnergy += row.droppedKineticEnergy;
    LedgerErrors& errors = m_account.handOvers;
    raise(errors.mass, relativeError(std::abs(row.fragments.mass - row.fe.mass), row.fe.mass));
    raise(errors.momentum, relativeError((row.fragments.linear - row.fe.linear).norm(), scale.linear));
    raise(errors.angularMomentum, relativeError((row.fragments.angular - row.fe.angular).norm(), scale.angular));
    raise(errors.bodyMass, relativeError(std::abs(row.bodies.mass - row.fe.mass), row.fe.mass));
    raise(errors.bodyMomentum, relativeError((row.bodies.linear - row.fe.linear).norm(), scale.linear));
    raise(errors.bodyAngularMomentum, relativeError((row.bodies.angular - row.fe.angular).norm(), scale.angular));
}

CarriedIslands::Change CarriedIslands::atState(std::size_t k, const HandOver& born, RigidWorld& world, Pieces& pieces,
                                               const Execution& execution, Findings& findings) {
    Change change;
    // What is loose at the last state is released there, as without this setting.
    if (!on() || k + 1 >= m_description.fe->stateCount()) {
        return change;
    }
    begin(execution);
    noteBlows(k, world);
    lose(k, born, world, change);
    take(k, world, pieces, change, findings);
    return change;
}

std::vector<Aabb> CarriedIslands::outlines(const RigidWorld& world) const {
    std::vector<Aabb> all;
    for (const Body& body : m_bodies) {
        if (body.there && world.state(body.id) != BodyState::Removed) {
            std::ranges::copy(rubble::outlines(body.island, world.motion(body.id).pose), std::back_inserter(all));
        }
    }
    return all;
}

std::int64_t CarriedIslands::awake(const RigidWorld& world) const {
    return std::ranges::count_if(m_bodies,
                                 [&](const Body& body) { return body.there && world.state(body.id) == BodyState::Awake; });
}

CarriedStructure CarriedIslands::outcome(const RigidWorld& world) const {
    CarriedStructure account = m_account;
    for (const Body& body : m_bodies) {
        if (body.there && world.state(body.id) != BodyState::Removed) {
            account.left += 1;
            account.leftMass += body.island.motion.mass;
        }
    }
    account.stillMoving = awake(world);
    return account;
}

void CarriedIslands::Body::keep(Archive& archive) {
    archive(id, state, island, there);
}

void CarriedIslands::keep(Archive& archive) {
    archive(m_bodies, m_carrier, m_gone, m_blows, m_account);
}

}  // namespace rubble
