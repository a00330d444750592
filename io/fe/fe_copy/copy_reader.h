#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"
#include "io/fe/fe_copy/copy_about.h"
#include "io/fe/fe_format.h"

namespace rubble::io {

bool recognisesFeCopy(const FileHead& head);

/// Reads a copy (copy_layout.h). What the settings say of variables was settled when the copy was made and is told in a finding.
/// Throws ParseError for what is damaged, also when a state is read; WorldError, Cancelled.
FeResult::Contents readFeCopy(const std::string& path, const ImportSettings& settings, const Execution& execution);

/// A copy as it lies there: contents in its own frame, and what it was made from.
struct FeCopy {
    FeResult::Contents contents;
    CopyAbout about;
};

/// Opens a copy and reads its tables, no states. Throws WorldError, ParseError.
FeCopy openFeCopy(const std::string& path);

}  // namespace rubble::io
