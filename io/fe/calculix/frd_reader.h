#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Result files of CalculiX (.frd), ASCII or binary.
bool recognisesFrd(const FileHead& head);
/// The file, the input deck beside it and its list of deaths.
std::vector<std::string> frdMembers(const std::string& path);
/// Reads a result file: its elements are written once, so deaths come from MODEL CHANGE of the deck, else from nodes that a state
/// leaves out. See FeFormat::read.
FeResult::Contents readFrd(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
