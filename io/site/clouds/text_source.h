#pragma once

#include <memory>
#include <optional>

#include "io/site/clouds/cloud_columns.h"
#include "io/site/clouds/cloud_lines.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Points that lie one on a line.
struct TextPoints {
    ColumnPlan plan;
    LineForm form;
    double colourScale = 1.0;
    std::optional<std::uint64_t> count;  ///< of lines of points; unset: all that follow
    std::size_t skipped = 0;             ///< lines in front of the points
    bool countsBetween = false;          ///< a whole number alone on a line says how many points follow
};

/// A cloud of lines of numbers. Lines with too few of them are left out and counted.
/// @param head  what the file says of itself
std::unique_ptr<CloudSource> textCloud(std::shared_ptr<const CloudFile> file, std::uint64_t start, TextPoints points,
                                       CloudHead head, Findings found);

}  // namespace rubble::io
