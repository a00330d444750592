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

/// What holds an axis away from the common multiple.
enum class ClampedBy : std::uint8_t {
    None,
    Spacing,        ///< d exceeds h_acc_max: no room from the start, the axis stays at h_acc_min
    FragmentSize,   ///< held at h_acc_min, because the multiple is below it or h_acc_min exceeds h_acc_max
    ComponentSize,  ///< held at h_acc_max
};
/// Why the search ended where it did.
enum class StoppedBy : std::uint8_t {
    Efficiency,      ///< the clusters counted as awake at once are at most N_A^max
    FpsUnreachable,  ///< more are counted at every grid up to the upper bounds; the run goes on there
    User,            ///< nothing was searched: a common multiple, all three sizes or one body per fragment were asked for
};
std::string_view clampedByName(ClampedBy by);  ///< "none", "spacing", "fragment_size", "component_size"
std::string_view stoppedByName(StoppedBy by);  ///< "efficiency", "fps_unreachable", "user"

/// Bounds of the Basic Grid along one axis (DESIGN.md 2.2) and who sets them.
struct AxisSizing {
    double meanDistance = 0.0;   ///< d, m
    double efficiencyMin = 0.0;  ///< h_eff_min = d cbrt(N_f / N_A^max), m; a guide
    double accuracyMin = 0.0;    ///< h_acc_min, m: outer size of the largest fragment
    double accuracyMax = 0.0;  ///< h_acc_max, m: smallest size of a structural component; extent of all fragments if there is none
    double extent = 0.0;       ///< of all fragments, m: beyond it nothing is left to join
    std::optional<FragmentId> largestFragment;
    std::optional<ComponentId> smallestComponent;
    double size = 0.0;      ///< the chosen size, m
    double multiple = 0.0;  ///< size / d
    ClampedBy clampedBy = ClampedBy::None;
};

/// Result of the search for the Basic Grid. Sizes and multiples are 0 where every fragment is its own body.
struct Sizing {
    std::array<AxisSizing, 3> axis;  ///< x, y, z
    BasicGrid grid;
    double commonMultiple = 0.0;  ///< of the mean distances, before clamping; 0 where all three sizes are set by hand
    std::size_t fragments = 0;
    std::int64_t bodiesMax = 0;
    double fpsTarget = 0.0;
    std::size_t clusters = 0;  ///< actually counted at the chosen grid, splits included
    std::size_t awake = 0;     ///< most of these at once, each from its birth on for the awake time
    StoppedBy stoppedBy = StoppedBy::Efficiency;
    double reachableFps = 0.0;  ///< fpsTarget, or fpsTarget * bodiesMax / awake if that is less (a guide until calibrated)
    Findings findings;          ///< conflicts of bounds, naming fragment and component; a target out of reach; many births
};

/// Searches the Basic Grid for a scenario (DESIGN.md 2.2); counts clusters with the same code that makes them, splits included.
/// A multiple or a size that the user sets is taken as it is, outside the bounds with a finding; an axis left open is searched.
/// Throws Cancelled.
Sizing sizeBasicGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components, const GridSettings& settings,
                     const Execution& execution);

}  // namespace rubble
