#pragma once

#include <string>

#include "io/fe_format.h"

namespace rubble::io {

/// Reads an LS-DYNA d3plot family: solids, thick shells, shells, beams and particles, both word sizes and byte orders; see
/// FeFormat::read. A family that is still being written opens up to its last complete state.
FeResult::Contents readD3plot(const std::string& path, const ImportSettings& settings, const Frame& frame,
                              const Execution& execution);

}  // namespace rubble::io
