#pragma once

#include <cstdint>

#include "core/base/message.h"
#include "core/engine/world/rigid_world.h"
#include "core/simulation/effects/decisions.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Steps per second that a run is simulated with at least: the scenario's, or by itself as many as its bodies need. In piles of
/// similar shape under gravity the time in which anything happens grows with the square root of the size (Froude); debris of
/// 0.8 m lies no nearer to its reference with more than 25 steps a second (docs/solver.md), so bodies of size d get
/// 40 sqrt(0.3 m / d), from 20 to 40. A pile of more than 10,000 has more layers, through which pushes have to get, and lies in
/// itself at such steps: up to 60 in place of 40, as the cube root of their number. d: median of the cube roots of the volumes, of
/// fragments alone where clusters break up. Where the engine moves loose structure at least 40: what spans fall on with 25 m/s
/// would be half a body deep in them after one longer step. 60 for Bullet's solver, whose piles squeeze together at larger steps.
/// Bodies of a table, each let go by itself, are judged one by one, not by their pile: a cube of side d that falls over its edge
/// turns at 0.79 sqrt(g / d), and by no more than 0.75 degrees in a step (60 sqrt(g / d)), from 40 to 480.
/// From the end of the FE result on nothing is born and few spans are left, so the least for these no longer holds once what still
/// falls has landed.
struct StepRate {
    double perSecond = 0.0;
    double settling = 0.0;  ///< 1/s, from the end of the FE result on, unless much still falls
    Message reason;
};
/// More than 2 % of the bodies present are faster than 3 m/s. What stood at the end of the FE result may fall apart later: then
/// the collapse goes on, in its own steps and substeps, until it has landed.
bool stillFalling(const RigidWorld& world, std::int64_t present);

/// In how many equal parts a step of dt [s] is simulated, so that no rolling body of a table turns by more than 0.75 degrees in
/// one: at most 32. A contact acts with the arms that it has when the step begins, so that longer ones brake what rolls: a granite
/// block of 26 corners went 7.0 m over level ground at 11 degrees a step, 8.2 at 3 and 8.5 to 8.7 from 1.4 on.
/// @param spin  rad/s, of the fastest
int partsOfStep(double spin, double dt);

/// A body of a table of more faces than this, triangles of a mesh, has more corners than a box, and rolls.
inline constexpr std::uint32_t facesOfBoxes = 12;

StepRate chosenStepRate(const RunDescription& description, const EffectDecisions& decisions);
double stepRateOf(const RunDescription& description, const EffectDecisions& decisions);

}  // namespace rubble
