#pragma once

#include <string>
#include <vector>

#include "core/validation/validate.h"

namespace rubble::cli {

/// Draws what was measured beside what was simulated, as SVG: the two cumulative curves of each quantity, and the map of where
/// bodies came to lie. Returns the files, SET-VARIANT-QUANTITY.svg and SET-VARIANT-map.svg. Throws WorldError.
std::vector<std::string> drawValidation(const std::vector<SetResult>& results, const std::string& folder);

}  // namespace rubble::cli
