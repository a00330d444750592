#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"
#include "core/scenario/scenario.h"

namespace rubble::io {

/// Opens an FE result, recognised by content: reads mesh, times and activity, leaves nodal fields to a lazy source.
/// @param settings  what the user says about the file; empty fields are recognised
/// @param frame     units, axes and origin of the case; applied to everything that leaves this function
/// Throws WorldError (cannot be read), ParseError (is not what it should be; names file, place and remedy), UsageError (a named
/// variable does not exist; lists those that do), Cancelled.
std::shared_ptr<const FeResult> openFe(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                       const Execution& execution);

}  // namespace rubble::io
