#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"
#include "io/fe/fe_format.h"

namespace rubble::io {

/// True if a file begins as netCDF or HDF5 does.
bool recognisesExodus(const FileHead& head);

/// The files of a sequence written at changes of topology, in order, of all processors that the name tells of; the file alone where
/// there is none.
std::vector<std::string> exodusMembers(const std::string& path);
/// Whether name and content say that one of several processors wrote the file; the name alone where it cannot be read.
bool isExodusPiece(const std::string& path);
/// Reads an Exodus II result; see FeFormat::read.
FeResult::Contents readExodus(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
