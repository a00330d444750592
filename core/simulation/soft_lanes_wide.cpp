// Compiled for 256-bit vectors; where there are none for the target, it holds nothing.
#ifdef RUBBLE_WIDE_LANES
#define RUBBLE_LANE_MAKE wide_lanes
#include "core/simulation/soft_lanes_passes.h"
#endif
