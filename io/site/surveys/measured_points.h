#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/outline.h"
#include "core/fe/frame.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"
#include "core/scenario/survey_scope.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Points that somebody measured.
struct MeasuredRequest {
    std::string path;   ///< a point cloud, a table of a total station (easting, northing, height in columns by name), or a DXF
    CloudRequest read;  ///< how a cloud or a table is read
    Frame frame;        ///< of the case
    Site site;
    std::optional<Registration> placed = std::nullopt;  ///< by which they are moved once they were brought to the case
    SurveyScope scope = {};                             ///< then those beyond it are left out
};

/// Most points of one file: what lies beyond does not fit into memory.
inline constexpr std::size_t measuredMost = 20'000'000;

/// Reads points into the local frame: all of a cloud or table, of a DXF its points and the corners of its lines with their heights.
/// A DXF names no system and is taken to lie in that of the case; lines at height 0 of a DXF whose others have heights are counted.
/// Throws ParseError (none of these, no point, too many), WorldError, Cancelled, and as CloudPlace.
std::vector<Vec3> readMeasuredPoints(const MeasuredRequest& request, Findings& findings, const Execution& execution);

/// m. Ends of lines of a drawing within it of each other are one corner.
inline constexpr double edgeReach = 0.05;
/// Corners of an edge at most.
inline constexpr std::size_t edgeCornersMost = 5'000;

/// Reads points that somebody measured along the edge of the debris, as an outline in the local frame: the rows of a table in their
/// order, or the lines of a drawing, joined at their ends; of a drawing without lines its points in their order. What is left open
/// is closed by a straight line, whose length is a finding. Registration and scope of the request do not count here.
/// Throws as readMeasuredPoints(), and ParseError (fewer than three places, too many, an edge that crosses itself).
Outline readMeasuredEdge(const MeasuredRequest& request, Findings& findings, const Execution& execution);

/// Whether a file holds points that somebody measured one by one: a table whose heading has their names, or a drawing without an
/// area. Throws WorldError.
bool holdsMeasuredPoints(const std::string& path);

}  // namespace rubble::io
