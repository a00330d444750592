#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/evidence/photographs/camera_match.h"
#include "core/evidence/surveys/pair_fit.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"
#include "io/site/surveys/named_points.h"

namespace rubble::io {

/// Reads pairs of a picture point and a point of the model from a table (see DelimitedTable): a heading row with the
/// columns picture_x_px, picture_y_px, x_m, y_m, z_m and, if there is one, name, in any order; others are passed over. A pair
/// without a name gets the number of its row.
/// Throws WorldError (cannot be read), ParseError (no such columns, a field that is no number, more fields than columns, too many
/// rows), with the line.
std::vector<PointPair> readPointPairs(const std::string& path);

/// Whether a table of pairs has no places of the model: its points are then those of a survey, by their names.
bool needsNamedPoints(const std::string& path);

/// Reads points of a picture (picture_x_px, picture_y_px and name) whose places are those of measured points of the same names.
/// Throws as above, and ParseError for a point that was not measured, naming it.
/// @param to  takes a place of `measured` into the frame of the pairs
std::vector<PointPair> readPointPairs(const std::string& path, std::span<const NamedPoint> measured,
                                      const std::function<Vec3(const Vec3&)>& to);

/// Pairs of a place in a survey and of where it belongs, as a table has them.
struct PlacePairTable {
    std::vector<PlacePair> pairs;  ///< as they stand there; `placed` is easting, northing and height in m
    bool metres = false;           ///< so is `surveyed`, in the system of the case; else in numbers of the survey
};

/// Reads such pairs from a table as above, with the columns survey_x, survey_y, survey_z in numbers of the survey, or survey_x_m,
/// survey_y_m, survey_z_m in metres of the system of the case; x_m, y_m, z_m, and if there are any name and deviation_m, the
/// standard deviation of x_m, y_m and z_m. Throws as above.
PlacePairTable readPlacePairs(const std::string& path);

/// Writes pairs of the case as a table that readPlacePairs() takes, in metres of the system of the case. @param pairs  local
/// Throws WorldError; UsageError as SitePlace.
void writePlacePairs(const std::string& path, const std::vector<PlacePair>& pairs, const Frame& frame, const Site& site);

}  // namespace rubble::io
