#include "core/simulation/effects/structure_contact.h"

#include "core/simulation/bodies/cluster_shape.h"
#include "core/simulation/effects/stopwatch.h"

namespace rubble {

namespace {

Scenario withPieces(const RunDescription& description, bool on) {
    Scenario scenario = description.scenario;
    if (!on) {
        scenario.simulation.pieces = PieceKind::None;
    }
    return scenario;
}

}  // namespace

StructureContact::StructureContact(const RunDescription& description, const Activity& activity, bool on)
    : m_pieces(*description.fe, *description.components, activity, withPieces(description, on),
               finestBrick(description.sizing.get())) {}

void StructureContact::beginInterval(RigidWorld& world, std::size_t k) {
    const Stopwatch watch(m_seconds);
    m_pieces.beginInterval(world, k);
}

void StructureContact::moveTo(RigidWorld& world, double share) {
    const Stopwatch watch(m_seconds);
    m_pieces.moveTo(world, share);
}

}  // namespace rubble
