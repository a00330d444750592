#pragma once

#include <array>

#include "core/clusters/partition.h"
#include "core/clusters/sizing.h"

namespace rubble {

/// The sizes that the search may give one axis [m].
struct AxisRange {
    double low = 0.0;
    double high = 0.0;
    ClampedBy lowBy = ClampedBy::None;  ///< what holds it at `low`; also where low == high
    ClampedBy highBy = ClampedBy::None;

    bool moves() const { return high > low; }
    double nearest(double wanted) const;
    ClampedBy clampedAt(double wanted) const;
};

/// An axis that the user has set.
AxisRange fixedRange(double size);

/// From the largest fragment to the smallest structural component; where these conflict, or the mean distance exceeds the
/// component, the size of the largest fragment.
AxisRange rangeOf(const AxisSizing& bounds);

/// Of nested clusters, which keep within a component whatever the grid: from nothing to where all that may be joined is joined.
AxisRange nestedRange(const AxisSizing& bounds);

/// Chooses the sizes (DESIGN.md 2.2) and fills sizing.grid, clusters, commonMultiple, stoppedBy and the chosen part of every axis.
///
/// Every axis takes the size nearest to the common multiple times its mean distance within its range, so an axis that is held
/// leaves its share to the others. The multiple rises from 1 by 5 % a step until at most bodiesMax of the clusters counted are
/// awake at once. The count is not monotone, hence the scan; the step that reached it is then halved down to 0.1 %, keeping a
/// multiple that was counted to suffice. If none does, not even where every axis has reached its upper bound, the run goes on
/// there: fps_unreachable. Nothing is searched where the user set a multiple or all three sizes.
void searchGrid(Partitioner& partitioner, const std::array<AxisRange, 3>& ranges, const GridSettings& settings,
                const Execution& execution, Sizing& sizing);

}  // namespace rubble
