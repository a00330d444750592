#include "core/simulation/soft_lanes.h"

#define RUBBLE_LANE_MAKE common_lanes
#include "core/simulation/soft_lanes_passes.h"

namespace rubble {

const LanePasses& commonLanePasses() {
    return common_lanes::passes;
}

const LanePasses& lanePasses() {
#ifdef RUBBLE_WIDE_LANES
    static const bool wide = __builtin_cpu_supports("avx2") != 0;
    return wide ? *wideLanePasses() : commonLanePasses();
#else
    return commonLanePasses();
#endif
}

}  // namespace rubble
