#pragma once

#include <ostream>

#include "app/cli/frame/json_output.h"
#include "io/site/clouds/cloud_comparison.h"
#include "io/site/clouds/run_distance.h"

namespace rubble::cli {

/// What is told of the distances between two clouds, with the keys of the manual.
Json cloudDistanceJson(const io::CloudComparison& made, const CloudDistanceSettings& settings);

/// The same for people.
void printCloudDistance(std::ostream& out, const io::CloudComparison& made, const CloudDistanceSettings& settings);

/// The same of the distances between a cloud and a run.
Json runDistanceJson(const io::RunDistance& made, const CloudDistanceSettings& settings);
void printRunDistance(std::ostream& out, const io::RunDistance& made, const CloudDistanceSettings& settings);

}  // namespace rubble::cli
