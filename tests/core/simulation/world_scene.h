#pragma once

#include "core/selftest/world_scene.h"

namespace rubble::test {

using selftest::boxBody;
using selftest::boxShape;
using selftest::WorldScene;

}  // namespace rubble::test
