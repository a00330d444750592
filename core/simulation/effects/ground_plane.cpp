#include "core/simulation/effects/ground_plane.h"

namespace rubble {

void setUpGroundPlane(const Scenario& scenario, WorldSettings& world) {
    world.ground = true;
    world.groundHeight = scenario.simulation.groundHeight;
    world.groundMaterial = scenario.effects.groundMaterial;
}

}  // namespace rubble
