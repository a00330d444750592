#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// Mass, linear momentum, angular momentum about the local origin, kinetic energy; sums of these make the ledger.
struct Momenta {
    double mass = 0.0;            ///< kg
    Vec3 linear = Vec3::Zero();   ///< kg m/s
    Vec3 angular = Vec3::Zero();  ///< kg m2/s, about the local origin
    double kineticEnergy = 0.0;   ///< J

    Momenta& operator+=(const Momenta& other);
};

/// Momenta of a rigid body with its centre of mass at x, inertia tensor about it in world axes, velocity v, angular velocity w.
Momenta rigidMomenta(double mass, const Vec3& x, const Mat3& inertia, const Vec3& v, const Vec3& w);

/// One deactivated element as a rigid solid, at the instant of its hand-over: its last active state.
struct Fragment {
    ElementIndex element{};
    ComponentId component{};
    std::uint32_t handOverState = 0;      ///< last state at which the element is active
    std::uint32_t birthState = 0;         ///< first state that reports it inactive
    double handOverTime = 0.0;            ///< s, time of handOverState
    double birthTime = 0.0;               ///< s, when it is shown and reported as born (state or exact, by setting)
    double endTime = 0.0;                 ///< s, when its element comes back to life (policy follow); infinity otherwise
    double mass = 0.0;                    ///< kg, volume at rest x density; positive
    Vec3 centre = Vec3::Zero();           ///< m, centre of mass
    Mat3 inertia = Mat3::Zero();          ///< kg m2 about the centre, world axes, from the consistent mass
    Vec3 velocity = Vec3::Zero();         ///< m/s of the centre
    Vec3 angularVelocity = Vec3::Zero();  ///< rad/s
    OrientedBox box;                      ///< tight around the solid, axes from the element's own rotation
    Aabb bounds;                          ///< of the solid, world axes
    Momenta fe;                           ///< of the element by quadrature of the nodal velocity field, before the rigid fit
};

/// All fragments of a scenario in FragmentId order (hand-over state, then element), and their solids.
struct FragmentSet {
    std::vector<Fragment> list;
    std::vector<std::uint32_t> vertexOffsets;  ///< first vertex of each fragment [fragments + 1]
    std::vector<Vec3> vertices;                ///< world positions at hand-over, m; shells and beams extruded to solids
    std::vector<ElementShape> solid;           ///< shape of the vertices: Hexahedron, Wedge, Pyramid or Tetrahedron [fragments]
    Findings findings;

    std::size_t size() const { return list.size(); }
    std::span<const Vec3> verticesOf(FragmentId f) const {
        return {vertices.data() + vertexOffsets[at(f)], vertexOffsets[at(f) + 1] - vertexOffsets[at(f)]};
    }
};

/// Turns every deactivated element into a fragment (DESIGN.md 2.1). An element that is never active gives none and is counted; one
/// that appears after the first state is counted and gives one if it dies later. A dying element whose positions are not numbers is
/// refused and counted. Mass, inertia and momenta come from the element at its last active state with its own thickness or section;
/// solid and box are what an engine can bear: never thinner than the settings say, not folded, not inside out. Fragments close with
/// their `fe` in mass, linear and angular momentum to rounding, unless they are born at rest by setting. A birth shift moves the
/// element before anything is taken from it, so that both sides of the ledger move. Reads each state of the FE result at most once,
/// in order. Throws Cancelled; UsageError when an element comes back to life under the policy refuse, or has no positive density.
FragmentSet makeFragments(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                          const Execution& execution);

}  // namespace rubble
