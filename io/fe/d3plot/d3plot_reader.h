#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// The members of a family, then the keyword deck that says what it cannot, where there is one; see FeFormat::members.
std::vector<std::string> d3plotFiles(const std::string& path);

/// Reads an LS-DYNA d3plot family: solids, thick shells, shells, beams and particles, both word sizes and byte orders; see
/// FeFormat::read. A family that is still being written opens up to its last complete state.
FeResult::Contents readD3plot(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
