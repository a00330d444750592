#pragma once

#include <ostream>

#include "app/cli/frame/json_output.h"
#include "io/site/clouds/cloud_comparison.h"

namespace rubble::cli {

/// What is told of the distances between two clouds, with the keys of the manual.
Json cloudDistanceJson(const io::CloudComparison& made, const io::CloudComparisonRequest& request);

/// The same for people.
void printCloudDistance(std::ostream& out, const io::CloudComparison& made, const io::CloudComparisonRequest& request);

/// A table of all core points; what is not known is an empty field.
void writeDistances(std::ostream& out, const io::CloudComparison& made);

}  // namespace rubble::cli
