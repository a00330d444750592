#pragma once

#include <ostream>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/evidence/photographs/camera_match.h"

namespace rubble::cli {

/// Residuals of a match, one row for each pair.
TextTable residualTable(const CameraMatch& match, const std::vector<PointPair>& pairs);
/// A match with the keys of `rubble-cli camera --json`.
Json matchJson(const CameraMatch& match, const std::vector<PointPair>& pairs);
/// The same for people: camera, residuals, verdict, pairs that look wrong.
void printMatch(std::ostream& out, const CameraMatch& match, const std::vector<PointPair>& pairs);

}  // namespace rubble::cli
