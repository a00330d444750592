#include "tests/scenes/fe_scenes.h"

#include "core/base/standard_gravity.h"

namespace rubble::scenes {

std::shared_ptr<const FeResult> collapsingWall(int nx, int nz) {
    Block wall;
    wall.name = "wall";
    wall.size = Vec3(nx, 1, nz);
    wall.cells = {nx, 1, nz};
    wall.deathState = [](std::size_t e) { return e % 2 == 0 ? std::size_t{2} : std::size_t{4}; };
    Block beam;
    beam.name = "beam";
    beam.low = Vec3(0, 0, nz + 1.0);
    beam.size = Vec3(nx, 1, 1);
    beam.cells = {nx, 1, 1};
    beam.gravity = standardGravity;
    return makeScene({wall, beam}, 7, 0.1);
}

}  // namespace rubble::scenes
