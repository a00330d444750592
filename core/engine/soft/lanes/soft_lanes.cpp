#include "core/engine/soft/lanes/soft_lanes.h"

#include <functional>

#define RUBBLE_LANE_VARIANT common_lanes
#include "core/engine/soft/lanes/soft_lanes_passes.h"

namespace rubble {

const LanePasses& commonLanePasses() {
    return common_lanes::passes;
}

const LanePasses& lanePasses() {
#ifdef RUBBLE_WIDE_LANES
    static const LanePasses& best = [] {
        const bool wide = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
        const bool widest = wide && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0;
        return std::cref(widest ? *widestLanePasses() : wide ? *wideLanePasses() : commonLanePasses());
    }();
    return best;
#else
    return commonLanePasses();
#endif
}

}  // namespace rubble
