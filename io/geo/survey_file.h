#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/survey.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// A survey as it was read.
struct SurveyInput {
    Survey survey;
    std::string path;
    std::string sha256;
    std::string crs;
    Frame frame;  ///< of the case that it was brought into
    Site site;
    Findings findings;
};

/// Reads a surveyed height model (anything that openTerrain() reads; gaps stay gaps) or the outline of the debris (polygons of a
/// GeoPackage, GeoJSON or Shapefile; of several layers that named "footprint", else all) into the local frame of a case. Of a
/// debris map of our own the heights are above the ground.
/// @param around  m, local, of the structure at rest; empty: all of a raster is read
/// Throws WorldError, ParseError (neither heights nor polygons, degrees in a case without a coordinate system), UsageError,
/// Cancelled.
SurveyInput readSurvey(const std::string& path, const Frame& frame, const Site& site, const Aabb& around,
                       const Execution& execution);

}  // namespace rubble::io
