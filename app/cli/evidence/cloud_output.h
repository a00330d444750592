#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "io/site/clouds/cloud_summary.h"

namespace rubble::cli {

/// What is told of a cloud, with the keys of the manual. @param photographs  paths that its pictures were written to, empty: none
Json cloudJson(const io::PointCloud& cloud, const io::CloudSummary& summary, const std::vector<std::string>& photographs);

/// The same for people.
void printCloud(std::ostream& out, const io::PointCloud& cloud, const io::CloudSummary& summary);

}  // namespace rubble::cli
