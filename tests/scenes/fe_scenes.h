#pragma once

#include <memory>

#include "core/fe/block_scene.h"

namespace rubble::scenes {

using blocks::Block;
using blocks::makeScene;
using blocks::never;

/// A wall of nx x 1 x nz blocks of 1 m that stands on the ground as part "wall", under a beam "beam" that falls row by row: every
/// second element of the wall dies at state 2, the rest of it at state 4; the beam stays alive and falls with gravity.
std::shared_ptr<const FeResult> collapsingWall(int nx = 4, int nz = 3);

}  // namespace rubble::scenes
