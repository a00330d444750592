#include "core/simulation/bodies/island_bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "core/engine/world/body_shapes.h"
#include "core/engine/world/bricks.h"
#include "core/engine/world/tight_box.h"
#include "core/fragments/element_place.h"
#include "core/fragments/element_solid.h"
#include "core/simulation/bodies/cluster_shape.h"
#include "core/simulation/bodies/element_nodes.h"

namespace rubble {

namespace {

/// Boxes of one body: enough for the deck of a bridge, few enough for the engine.
constexpr std::size_t partsMax = 64;
/// Volume at rest below this share of the box around an element is rounding.
constexpr double leastFill = 1e-9;

Vec3 restCentre(const Mesh& mesh, ElementIndex e) {
    Vec3 centre = Vec3::Zero();
    for (const std::uint32_t node : mesh.cornersOf(e)) {
        centre += mesh.nodes[node];
    }
    return centre / static_cast<double>(mesh.cornersOf(e).size());
}

bool finite(const Momenta& m) {
    return std::isfinite(m.mass) && m.linear.allFinite() && m.angular.allFinite() && std::isfinite(m.kineticEnergy);
}

void giveBricks(IslandBody& body, const RunDescription& description) {
    std::vector<OrientedBox> bricks;
    for (const IslandElement& part : body.parts) {
        bricks.push_back(boxIn(body.pose, brickOf(part.solid, part.vertices)));
    }
    body.shape = bricksShape(bricks, description.scenario.fragments, finestBrick(description.sizing.get()));
}

void giveCells(IslandBody& body, const RunDescription& description) {
    const FragmentSettings& settings = description.scenario.fragments;
    const std::vector<IslandElement>& parts = body.parts;
    using Cell = std::tuple<std::size_t, double, double, double>;
    Vec3 low = parts.front().rest;
    std::set<std::size_t> components;
    for (const IslandElement& part : parts) {
        low = low.cwiseMin(part.rest);
        components.insert(at(part.component));
    }
    const bool byComponent = components.size() <= partsMax;
    // Ordered, so that the parts of a body come in the same order every time.
    std::map<Cell, std::vector<std::size_t>> cells;
    for (double size = description.scenario.simulation.pieceSize;; size *= 2.0) {
        cells.clear();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Vec3 cell = (parts[i].rest - low) / size;
            cells[{byComponent ? at(parts[i].component) : 0, std::floor(cell.x()), std::floor(cell.y()), std::floor(cell.z())}]
                .push_back(i);
        }
        if (cells.size() <= partsMax) {
            break;
        }
    }
    const Quat inverse = body.pose.orientation.conjugate();
    for (const auto& [cell, members] : cells) {
        std::vector<Vec3> points;
        for (const std::size_t i : members) {
            for (const Vec3& p : parts[i].vertices) {
                points.push_back(inverse * (p - body.pose.position));
            }
        }
        ConvexPart part;
        std::vector<Mat3> axes;
        for (const std::size_t i : {members.front(), members[members.size() / 2], members.back()}) {
            axes.push_back((inverse * parts[i].box.orientation).toRotationMatrix());
        }
        part.box = tightBox(points, axes);
        const double least = minimumHalfExtent(part.box.halfExtents, settings.minimumThicknessRatio, settings.minimumHalfExtent);
        part.box.halfExtents = part.box.halfExtents.cwiseMax(least);
        body.shape.push_back(part);
    }
}

}  // namespace

bool giveBody(IslandBody& body, const RunDescription& description) {
    std::vector<MovingMass> masses;
    std::map<std::size_t, double> volumes;
    body.volume = 0.0;
    for (const IslandElement& part : body.parts) {
        const double volume = description.components->volume[at(part.element)];
        volumes[at(part.component)] += volume;
        if (part.motion.mass > 0.0) {
            masses.push_back(part.motion);
            body.volume += volume;
        }
    }
    if (masses.empty()) {
        return false;
    }
    std::vector<std::uint32_t> all(masses.size());
    std::iota(all.begin(), all.end(), 0u);
    body.motion = joinRigidly(masses, all);
    const auto largest =
        std::max_element(volumes.begin(), volumes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    body.component = idAt<ComponentId>(largest->first);
    if (!(body.motion.mass > 0.0) || !body.motion.inertia.allFinite() || !body.motion.angularVelocity.allFinite()) {
        return false;
    }
    const BodyFrame frame = bodyFrame(body.motion.centre, body.motion.inertia);
    body.pose = frame.pose;
    body.inertia = frame.inertia;
    if (!(frame.inertia.minCoeff() > 0.0)) {
        return false;
    }
    body.shape.clear();
    if (shapeOfClusters(description.scenario) == ClusterShape::Bricks) {
        giveBricks(body, description);
    } else {
        giveCells(body, description);
    }
    return true;
}

IslandMaker::IslandMaker(const RunDescription& description, const Activity& activity, std::span<const LiveIsland> islands,
                         std::size_t state)
    : m_description(description),
      m_activity(activity),
      m_motion(*description.fe, description.scenario.fragments.revival),
      m_state(static_cast<std::uint32_t>(state)) {
    std::vector<Lifetime> lives;
    for (const LiveIsland& island : islands) {
        for (const ElementIndex e : island.elements) {
            lives.push_back(lifeOf(e));
        }
    }
    const std::vector<bool> needed = m_motion.statesNeeded(lives);
    for (std::uint32_t k = 0; k < needed.size() && k <= m_state; ++k) {
        if (needed[k]) {
            m_motion.advance(k);
        }
    }
}

Lifetime IslandMaker::lifeOf(ElementIndex element) const {
    Lifetime life;
    life.element = element;
    life.lastActive = life.firstActive = m_state;
    while (life.firstActive > 0 && m_activity.active(life.firstActive - 1, element)) {
        --life.firstActive;
    }
    return life;
}

bool IslandMaker::addElement(ElementIndex element, IslandBody& body) {
    const Components& components = *m_description.components;
    const FragmentSettings& settings = m_description.scenario.fragments;
    const LeastExtents extents{settings.minimumThicknessRatio, settings.minimumHalfExtent};
    const CornerMotion motion = m_motion.motionOf(lifeOf(element));
    const Mesh& mesh = m_description.fe->mesh();
    if (!motion.finite || !restCentre(mesh, element).allFinite()) {
        return false;
    }
    m_withoutVelocity += motion.known == 0;
    const ElementSolid solid = elementSolid(mesh, element, motion, components.section[at(element)], extents);
    IslandElement& part = body.parts.emplace_back();
    part.element = element;
    part.component = components.of[at(element)];
    part.rest = restCentre(mesh, element);
    part.box = solid.sound.box;
    part.solid = solid.sound.shape;
    for (int a = 0; a < cornerCount(solid.sound.shape); ++a) {
        part.vertices.emplace_back(solid.sound.corners.col(a));
    }
    // Without volume at rest it weighs nothing and goes along.
    const double mass = components.mass(element);
    if (!(mass > 0.0) || !std::isfinite(mass) || components.volume[at(element)] < leastFill * solid.sound.box.volume()) {
        return true;
    }
    const RigidFit fit = fitRigidMotion(solid, mass, extents);
    MovingMass moving{mass, fit.centre, fit.inertia, fit.velocity, fit.angularVelocity};
    if (settings.birthVelocity == BirthVelocity::Rest) {
        moving.velocity = moving.angularVelocity = Vec3::Zero();
    }
    part.motion = moving;
    body.fe += fit.field;
    body.rigid += rigidMomenta(mass, moving.centre, moving.inertia, moving.velocity, moving.angularVelocity);
    return true;
}

std::optional<IslandBody> IslandMaker::make(const LiveIsland& island, Findings& findings) {
    IslandBody body;
    body.elements = island.elements;
    m_withoutVelocity = 0;
    bool sound = true;
    for (const ElementIndex e : island.elements) {
        sound = sound && addElement(e, body);
    }
    sound = sound && giveBody(body, m_description) && finite(body.fe) && finite(body.rigid);
    const std::string place = elementPlace(m_description.fe->mesh(), *m_description.components, island.elements.front(), m_state);
    if (!sound) {
        findings.add(
            {"simulation.island_refused",
             "Islands of live structure without a finite place, mass or inertia are held where they are",
             {}},
            {"simulation.island_refused.remedy", "look at the named element in the FE file; check density and coordinates", {}},
            place);
        return std::nullopt;
    }
    if (m_withoutVelocity > 0) {
        findings.add({"simulation.island_no_velocity", "The velocity of elements of released islands is not known", {}},
                     {"simulation.island_no_velocity.remedy",
                      "They were active at a single state of a result without velocities and are released at rest.",
                      {}},
                     place, static_cast<std::int64_t>(m_withoutVelocity));
    }
    return body;
}

NewBody newBody(const IslandBody& island, const RunDescription& description) {
    NewBody body;
    body.mass = island.motion.mass;
    body.inertia = island.inertia;
    body.pose = island.pose;
    body.velocity = island.motion.velocity;
    body.angularVelocity = island.motion.angularVelocity;
    body.shape = island.shape;
    body.smallestSide = smallestSide(island.shape);
    body.volume = island.volume;
    body.material = description.components->list[at(island.component)].material;
    body.nodes = nodesOf(description.fe->mesh(), island.elements);
    return body;
}

}  // namespace rubble
