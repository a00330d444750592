#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/octree/cloud_octree.h"

namespace rubble::cli {

/// What is told of a cloud, with the keys of the manual. @param photographs  paths that its pictures were written to, empty: none
Json cloudJson(const io::PointCloud& cloud, const io::CloudSummary& summary, const std::vector<std::string>& photographs);

/// What is told of the octree of a cloud. @param seconds  that opening or making it took
Json octreeJson(const io::OpenedOctree& index, double seconds);

/// The same for people.
void printCloud(std::ostream& out, const io::PointCloud& cloud, const io::CloudSummary& summary);
void printOctree(std::ostream& out, const io::OpenedOctree& index, double seconds);

}  // namespace rubble::cli
