#pragma once

#include <optional>

#include "core/scenario/scenario.h"
#include "io/fe/exodus/exodus_file.h"
#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

/// The displacement of a file: as set, else by the usual names; nothing where the user says that nodes do not move. Throws
/// UsageError or ParseError, which list the variables that there are.
std::optional<VectorVariable> chooseDisplacement(const ExodusFile& file, const ImportSettings& settings);
/// Throws ParseError for files of flat analyses.
void requireThreeDimensions(const ExodusFile& file);

}  // namespace rubble::io
