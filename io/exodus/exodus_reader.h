#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"
#include "core/scenario/scenario.h"

namespace rubble::io {

/// True if a file begins as netCDF or HDF5 does. @param head  its first bytes
bool looksLikeExodus(std::string_view head);

/// Opens an Exodus II result; see openFe() for arguments and errors.
std::shared_ptr<const FeResult> openExodus(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                           const Execution& execution);

}  // namespace rubble::io
