// A wall of 4 x 1 x 3 blocks that hangs in the air and loses all of them within half a second: from an FE result that is made in
// memory to where the fragments lie. Needs the core alone.

#include <core/base/build.h>
#include <core/base/error.h>
#include <core/base/version.h>
#include <core/fe/block_scene.h>
#include <core/pipeline/pipeline.h>
#include <core/scenario/parameters.h>

#include <algorithm>
#include <cstdio>
#include <string>

int main() {
    std::printf("Rubble %s, headers %d.%d.%d\n", std::string(rubble::versionText()).c_str(), RUBBLE_VERSION_MAJOR,
                RUBBLE_VERSION_MINOR, RUBBLE_VERSION_PATCH);
    rubble::blocks::Block wall;
    wall.name = "wall";
    wall.low = {0, 0, 4};
    wall.size = {2, 0.5, 1.5};
    wall.cells = {4, 1, 3};
    wall.gravity = 9.80665;
    wall.deathState = [](std::size_t element) { return 1 + element % 5; };

    rubble::Inputs inputs;
    inputs.fe = rubble::blocks::makeScene({wall}, 6, 0.1);
    rubble::Scenario scenario;
    try {
        rubble::setParameterText(scenario, "preset", "reference");
        rubble::setParameterText(scenario, "settle_time", "3");
        rubble::MemoryTrajectory trajectory;
        const rubble::Results results =
            rubble::run(inputs, scenario, rubble::Stage::Simulation, {}, &trajectory, rubble::Execution());
        double highest = 0.0;
        for (const rubble::FragmentOutcome& fragment : results.simulation->fragments) {
            highest = std::max(highest, fragment.finalPosition.z());
        }
        std::printf("%zu fragments, %zu bodies, %zu frames up to %.2f s, highest at rest %.2f m, trajectory %s\n",
                    results.fragments->size(), trajectory.bodies().size(), trajectory.frameCount(), results.simulation->endTime,
                    highest, results.simulation->trajectoryHash.hex().c_str());
    } catch (const rubble::Error& error) {
        std::fprintf(stderr, "%s: %s\n", error.message().id.c_str(), error.what());
        return 1;
    }
    return 0;
}
