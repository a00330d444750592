#pragma once

#include <optional>
#include <string>

#include "io/fe/vtk/grid.h"

namespace rubble::io {

/// Reads an unstructured grid of VTK XML (.vtu), all pieces one after the other. Throws ParseError naming the file and the array.
Grid readXmlGrid(const std::string& path, const GridSelection& selection);

/// The time that its field data say, if they do. Throws as readXmlGrid().
std::optional<double> timeOfXmlGrid(const std::string& path);

}  // namespace rubble::io
