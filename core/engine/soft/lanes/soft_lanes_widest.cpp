#include "core/engine/soft/lanes/soft_lanes.h"

#ifdef RUBBLE_WIDE_LANES
#define RUBBLE_LANE_VARIANT widest_lanes
#include "core/engine/soft/lanes/soft_lanes_passes.h"
#endif

namespace rubble {

const LanePasses* widestLanePasses() {
#ifdef RUBBLE_WIDE_LANES
    return &widest_lanes::passes;
#else
    return nullptr;
#endif
}

}  // namespace rubble
