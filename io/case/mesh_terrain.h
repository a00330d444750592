#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"
#include "io/site/height_reading.h"

namespace rubble::io {

/// The heights of a mesh on cells of half the size of its triangles, in the local frame; nodes that no triangle lies over are gaps.
/// Where a mesh has surfaces above each other it is no height function: the highest is taken, and such nodes are a counted finding.
/// Throws as readSiteMesh(), and ParseError for a mesh that is upright all over.
HeightReading heightsOfMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution);

}  // namespace rubble::io
