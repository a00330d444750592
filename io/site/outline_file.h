#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/maps/footprint.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Polygons of a file in the local frame.
struct OutlineReading {
    Outline outline;
    bool debrisMap = false;   ///< it is a map of our own: cells that debris reaches into
    std::int64_t fallen = 0;  ///< polygons that a map of our own calls live structure, taken in or left out
    std::string crs;          ///< name of the file's system, empty if it states none
    Findings findings;
};

/// Reads the polygons of a GeoPackage, GeoJSON, Shapefile, FlatGeobuf or KML, or the closed lines of a DXF: of several layers the
/// one named "footprint", else all. Another system is brought to that of the case. What is assumed or left out is a counted
/// finding.
/// @param withFallen  of a map of our own: fallen live structure is taken in
/// @return unset if the file is none of these formats, or has no layer
/// Throws ParseError (no polygon, too many corners, degrees in a case without a coordinate system, elsewhere than can be mapped),
/// UsageError (control points), Cancelled.
std::optional<OutlineReading> readOutline(const std::string& path, const Frame& frame, const Site& site, bool withFallen,
                                          const Execution& execution);

/// Whether readOutline() takes a file as one of these formats, whatever is in it.
bool holdsOutline(const std::string& path);

}  // namespace rubble::io
