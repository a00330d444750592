#include "core/validation/standing_world.h"

#include <cmath>

#include "core/scenario/scenario.h"

namespace rubble {

std::unique_ptr<RigidWorld> standingWorld(double friction, const Execution& execution) {
    WorldSettings settings;
    settings.pairs = PairTable::uniform(friction, 0.0);
    settings.ground = false;
    settings.substeps = substepsOf(Scenario());
    settings.partsJammed = settings.steadyPatches = true;
    settings.threads = execution.threads();
    settings.cancelled = [execution] { return execution.cancelled(); };
    return makeWorld(SolverKind::SoftStep, settings);
}

bool staysInPlace(RigidWorld& world, const std::vector<Vec3>& places, double moved, double seconds, double stepRate,
                  const Execution& execution) {
    const auto steps = static_cast<int>(std::lround(seconds * stepRate));
    for (int i = 0; i < steps; ++i) {
        world.step(1.0 / stepRate);
        execution.check();
        for (std::size_t b = 0; b < places.size(); ++b) {
            if (!((world.motion(idAt<BodyId>(b)).pose.position - places[b]).norm() < moved)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace rubble
