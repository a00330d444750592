#pragma once

#include "core/simulation/bodies/pieces.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// The structure that is still active pushes and carries bodies: kinematic pieces of its elements move as the FE result says, at
/// constant velocity within a step, and vanish with their elements (pieces.h). A piece has no momentum of its own to lose: it
/// gives what its motion asks for, up to a limit at which it yields (rigid_world.h), and the work it does is booked.
///
/// Limits: debris does not load the structure back; a piece is a box, a component or a hull, not its elements.
class StructureContact {
public:
    /// @param activity  under the revival policy; must outlive this object
    /// @param on        false: there is no piece, ever
    StructureContact(const RunDescription& description, const Activity& activity, bool on);

    /// The interval from state k to k + 1 begins.
    void beginInterval(RigidWorld& world, std::size_t k);
    /// Moves the pieces to where they are at a share of the interval in (0, 1].
    void moveTo(RigidWorld& world, double share);
    /// From now on everything stands still.
    void hold() { m_pieces.hold(); }
    Pieces& pieces() { return m_pieces; }
    /// s of wall time spent here so far; contact itself is the world's.
    double seconds() const { return m_seconds; }
    void keep(Archive& archive) { archive(m_pieces, m_seconds); }

private:
    Pieces m_pieces;
    double m_seconds = 0.0;
};

}  // namespace rubble
