#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Unstructured grids as XML: .vtu, .pvtu, .vtm, .pvd and .vtu.series.
bool recognisesVtkXml(const FileHead& head);
/// Unstructured grids in the legacy format, and .vtk.series.
bool recognisesVtkLegacy(const FileHead& head);
/// The files of the series a file belongs to: the index that lists it first, if there is one; else all files of its number series.
std::vector<std::string> vtkMembers(const std::string& path);
/// Whether a .pvtu or .vtm near a file names it as a piece of a state.
bool isVtkPiece(const std::string& path);
/// The grid itself, or an index and what it names, without others that differ in a number.
std::vector<std::string> vtkFilesAlone(const std::string& path);
/// Reads a series of unstructured grids in files; see FeFormat::read.
FeResult::Contents readVtk(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
