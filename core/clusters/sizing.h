#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/clusters/basic_grid.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

enum class ClampedBy { None, Spacing, FragmentSize, ComponentSize };
enum class StoppedBy { Efficiency, FpsUnreachable, User };
std::string_view clampedByName(ClampedBy by);  ///< "none", "spacing", "fragment_size", "component_size"
std::string_view stoppedByName(StoppedBy by);  ///< "efficiency", "fps_unreachable", "user"

/// Bounds of the Basic Grid along one axis (DESIGN.md 2.2) and who sets them.
struct AxisSizing {
    double meanDistance = 0.0;   ///< d, m
    double efficiencyMin = 0.0;  ///< h_eff_min = d cbrt(N_f / N_A^max), m; a guide
    double accuracyMin = 0.0;    ///< h_acc_min, m: outer size of the largest fragment
    double accuracyMax = 0.0;    ///< h_acc_max, m: smallest size of a structural component
    std::optional<FragmentId> largestFragment;
    std::optional<ComponentId> smallestComponent;
    double size = 0.0;      ///< the chosen size, m
    double multiple = 0.0;  ///< size / d
    ClampedBy clampedBy = ClampedBy::None;
};

/// Result of the search for the Basic Grid.
struct Sizing {
    std::array<AxisSizing, 3> axis;  ///< x, y, z
    BasicGrid grid;
    double commonMultiple = 0.0;  ///< before clamping
    std::size_t fragments = 0;
    std::int64_t bodiesMax = 0;
    double fpsTarget = 0.0;
    std::size_t clusters = 0;  ///< actually counted at the chosen grid, splits included
    StoppedBy stoppedBy = StoppedBy::Efficiency;
    double reachableFps = 0.0;  ///< when the target is out of reach: fpsTarget * bodiesMax / clusters (guide until calibrated)
    Findings findings;          ///< conflicts of bounds, naming fragment and component
};

/// Searches the Basic Grid for a scenario; counts clusters with the same code that makes them.
Sizing sizeBasicGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components, const GridSettings& settings,
                     const Execution& execution);

}  // namespace rubble
