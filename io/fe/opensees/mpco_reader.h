#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Files of the recorder mpco of OpenSees, in HDF5.
bool recognisesMpco(const FileHead& head);
/// The file, or all pieces of a parallel analysis (NAME.part-0.mpco, ...), and a list of deaths. Never throws.
std::vector<std::string> mpcoMembers(const std::string& path);
/// Whether its name is that of a piece of a parallel analysis. Never throws.
bool isMpcoPiece(const std::string& path);
/// Reads one; pieces are joined by the numbers of their nodes and elements, unless `onlyThisFile` is set. Throws as openFe().
FeResult::Contents readMpco(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
