#pragma once

#include <string>
#include <vector>

#include "io/vtk/grid.h"

namespace rubble::io {

/// Reads one unstructured grid, legacy (.vtk) or XML (.vtu), by VTK's own readers; nothing of theirs reaches the terminal.
/// Throws ParseError naming the file and what VTK says.
Grid readGridFile(const std::string& path, const GridSelection& selection);

/// Reads all files once in a child process with bounded memory: VTK's readers may crash on damaged files. Throws ParseError for the
/// first that cannot be read.
void tryGridFiles(const std::vector<std::string>& paths);

}  // namespace rubble::io
