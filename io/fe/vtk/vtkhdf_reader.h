#pragma once

#include <string>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// HDF5 files with the group VTKHDF.
bool recognisesVtkHdf(const FileHead& head);
/// Reads an unstructured grid of VTKHDF 1.0 (one state) or 2.x (with Steps); see FeFormat::read.
FeResult::Contents readVtkHdf(const std::string& path, const ImportSettings& settings, const Execution& execution);
/// The file, and its list of deaths where there is one.
std::vector<std::string> aloneWithDeathList(const std::string& path);

}  // namespace rubble::io
