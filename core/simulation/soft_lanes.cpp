#define RUBBLE_LANE_MAKE common_lanes
#include "core/simulation/soft_lanes_passes.h"

namespace rubble {

#ifdef RUBBLE_WIDE_LANES
namespace wide_lanes {
extern const LanePasses passes;
}
#endif

const LanePasses& lanePasses() {
#ifdef RUBBLE_WIDE_LANES
    static const bool wide = __builtin_cpu_supports("avx2") != 0;
    return wide ? wide_lanes::passes : common_lanes::passes;
#else
    return common_lanes::passes;
#endif
}

}  // namespace rubble
