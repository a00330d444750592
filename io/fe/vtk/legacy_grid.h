#pragma once

#include <optional>
#include <string>

#include "io/fe/vtk/grid.h"

namespace rubble::io {

/// Reads an unstructured grid of the legacy VTK format (.vtk), text or binary, versions 1 to 5. Layout after the VTK file format
/// specification. Throws ParseError naming the file and the byte, WorldError.
Grid readLegacyGrid(const std::string& path, const GridSelection& selection);

/// The time that its field data say, if they do. Throws as readLegacyGrid().
std::optional<double> timeOfLegacyGrid(const std::string& path);

}  // namespace rubble::io
