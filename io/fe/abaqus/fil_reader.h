#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Results files of Abaqus (.fil), ASCII or binary.
bool recognisesFil(const FileHead& head);
/// The file, the input deck beside it and its list of deaths.
std::vector<std::string> filMembers(const std::string& path);
/// Reads a results file: an element is dead where every record STATUS of it in an increment is 0; in files without STATUS where its
/// records are missing while others of its request are there. See FeFormat::read.
FeResult::Contents readFil(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
