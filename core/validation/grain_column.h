#pragma once

#include <cstdint>

#include "core/base/execution.h"
#include "core/base/geometry.h"

namespace rubble {

/// A round column of box-shaped grains that are poured into a vessel. The vessel, without friction, then vanishes.
struct GrainColumn {
    Vec3 grain = Vec3::Constant(0.14);  ///< m, sides of a grain
    double radius = 1.0;                ///< m, of the vessel
    double aspect = 4.0;                ///< height over radius that is poured for, at a solid fraction of 0.6
    double friction = 0.6;              ///< of every contact but those of the vessel
    std::uint64_t seed = 1;
};

/// What became of a column.
struct ColumnDeposit {
    int grains = 0;
    double aspect = 0.0;         ///< height of the column over its radius, as it stood: mean height of its surface
    double solidFraction = 0.0;  ///< of the column as it stood
    double runOut = 0.0;         ///< (r - r0) / r0, r the mean over 16 sectors of the edge of what hangs together
    double height = 0.0;         ///< of the deposit around its axis, over the first radius
};

/// Pours, releases and measures. The same column gives the same numbers. Throws Cancelled.
ColumnDeposit collapseOf(const GrainColumn& column, const Execution& execution);

}  // namespace rubble
