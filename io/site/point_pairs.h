#pragma once

#include <string>
#include <vector>

#include "core/evidence/photographs/camera_match.h"
#include "core/evidence/surveys/pair_fit.h"

namespace rubble::io {

/// Reads pairs of a picture point and a point of the model from a table (see DelimitedTable): a heading row with the
/// columns picture_x_px, picture_y_px, x_m, y_m, z_m and, if there is one, name, in any order; others are passed over. A pair
/// without a name gets the number of its row.
/// Throws WorldError (cannot be read), ParseError (no such columns, a field that is no number, more fields than columns, too many
/// rows), with the line.
std::vector<PointPair> readPointPairs(const std::string& path);

/// Reads pairs of a place in a survey and of where it belongs from a table as above, with the columns survey_x, survey_y, survey_z,
/// in numbers of the survey, x_m, y_m, z_m, and if there is one name. Throws as above.
std::vector<PlacePair> readPlacePairs(const std::string& path);

}  // namespace rubble::io
