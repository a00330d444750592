#pragma once

#include <string>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Result files of Ansys MAPDL (.rst).
bool recognisesRst(const FileHead& head);
/// Reads mesh, times and displacements of a result file. Which elements are dead comes from a list of deaths beside it: the file's
/// own list is of no verified meaning. See FeFormat::read.
FeResult::Contents readRst(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
