#pragma once

#include <optional>
#include <string>

#include "io/fe/vtk/grid.h"

namespace rubble::io {

/// Reads one unstructured grid, legacy (.vtk) or XML (.vtu). Throws ParseError naming the file and the place, WorldError.
Grid readGridFile(const std::string& path, const GridSelection& selection);

/// The time that a grid says in its field data, if it does; reads no further than it needs. Throws as readGridFile().
std::optional<double> timeOfGridFile(const std::string& path);

/// Throws as readGridFile() for a file that is cut off or damaged in its structure.
void requireWholeGrid(const std::string& path);

}  // namespace rubble::io
