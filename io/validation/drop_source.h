#pragma once

#include <string>
#include <vector>

#include "core/validation/drop_series.h"
#include "io/case/open_case.h"
#include "io/fe/bodies/body_table.h"

namespace rubble::io {

/// How a table of bodies is dropped.
struct DropRequest {
    CaseRequest opening;  ///< `path` is that of the table
    bool turned = false;
    bool lifted = false;
    bool apart = false;
    std::int64_t repeats = 1;
    std::int64_t seed = 1;
    std::vector<VariedSetting> varied;
    double samplesPerSecond = 0.0;  ///< of the paths; 0: none
};
inline constexpr std::int64_t dropRepeatsMax = 10000;

/// A table of bodies as it was asked to be dropped.
struct DropSource {
    OpenedCase opened;
    BodyTable table;
    DropSeries series;
    Vec3 zero = Vec3::Zero();  ///< m, of the local frame in the axes of the table
    Findings findings;
};

/// Opens a table. Throws as readBodyTable() and openCase(); ParseError for bodies that begin outside the terrain, below it unless
/// they are lifted, or too many in one place unless they never meet; UsageError for repeats, seeds and variations out of range.
DropSource openDrop(const DropRequest& request, const Execution& execution);

/// What was met on the way over all repeats, what did not come to rest among it.
Findings findingsOf(const DropSource& source, const std::vector<DropRepeat>& repeats);

}  // namespace rubble::io
