#pragma once

#include <string>

#include "core/base/finding.h"

namespace rubble::io {

/// Metres of one unit of a drawing (DXF), as its header says by $INSUNITS; 1 where it says nothing of use. Tells of any unit but
/// the metre, and that none is said. Throws WorldError.
double drawingUnit(const std::string& path, Findings& findings);

}  // namespace rubble::io
