#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Result files of Ansys MAPDL (.rst).
bool recognisesRst(const FileHead& head);
/// The file, or those of all processes of a distributed analysis, and a list of deaths.
std::vector<std::string> rstMembers(const std::string& path);
/// Whether a file holds the nodes of one process alone. Never throws.
bool isRstPiece(const std::string& path);
/// Reads mesh, times and displacements of a result file. Which elements are dead comes from a list of deaths beside it: the file's
/// own list is of no verified meaning. See FeFormat::read.
FeResult::Contents readRst(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
