#include "core/fragments/element_solid.h"

namespace rubble {

namespace {

/// Share of the minimum thickness below which mass is spread no thinner: a needle must not spin on rounding.
constexpr double leastMassSpread = 0.1;

Corners referenceOf(const Mesh& mesh, ElementIndex element) {
    Corners corners = Corners::Zero();
    int a = 0;
    for (const std::uint32_t node : mesh.cornersOf(element)) {
        corners.col(a++) = mesh.nodes[node];
    }
    return corners;
}

}  // namespace

ElementSolid elementSolid(const Mesh& mesh, ElementIndex element, const CornerMotion& motion, double section,
                          const LeastExtents& extents) {
    const ElementShape shape = mesh.shapes[at(element)];
    ElementSolid solid;
    solid.moving = solidOf(shape, motion.positions, motion.velocities, section);
    solid.present = asHexahedron(solid.moving.shape, solid.moving.positions);
    const MovingSolid atRest = solidOf(shape, referenceOf(mesh, element), Corners::Zero(), section);
    solid.unit = consistentMass(solid.present, 1.0);
    solid.sound = soundSolid(solid.moving, solid.unit.state, solid.unit.volume,
                             boxAxes(asHexahedron(atRest.shape, atRest.positions), solid.present), extents.ratio, extents.least);
    return solid;
}

RigidFit fitRigidMotion(const ElementSolid& solid, double mass, const LeastExtents& extents) {
    ConsistentMass consistent = solid.unit;
    consistent.matrix *= mass;
    const double minimum = minimumHalfExtent(solid.sound.box.halfExtents, extents.ratio, extents.least);
    return fitRigidMotion(consistent, solid.present, asHexahedron(solid.moving.shape, solid.moving.velocities),
                          leastMassSpread * minimum);
}

}  // namespace rubble
