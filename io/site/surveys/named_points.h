#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"

namespace rubble::io {

/// A measured point that somebody gave a name.
struct NamedPoint {
    std::string name;
    Vec3 place = Vec3::Zero();  ///< m: easting, northing and height, in metres where no heading names another unit
};

/// Reads named points of a total station: a table with a heading (name, point, id or number; easting, northing and height, or x, y
/// and z, in any order), or a DXF, whose points are called by the text nearest to them, within a metre. Points without a name, and
/// those of a drawing at height 0 while others have heights, are left out and counted.
/// Throws WorldError, ParseError (no such columns, a field that is no number, a name twice, no named point), Cancelled.
std::vector<NamedPoint> readNamedPoints(const std::string& path, Findings& findings, const Execution& execution);

/// Whether the heading of a table of at most 1 MiB names points and their coordinates. Throws WorldError.
bool namesStationPoints(const std::string& path);

}  // namespace rubble::io
