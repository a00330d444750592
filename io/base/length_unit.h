#pragma once

#include <optional>
#include <string_view>

namespace rubble::io {

/// Metres in a unit of length, by a name that rasters, tables and people give it in any case, with or without blanks, hyphens,
/// points and underlines. Nothing: it is no unit of length that is known. Survey feet are 1200/3937 m, other feet 0.3048 m.
std::optional<double> metresInUnit(std::string_view name);

}  // namespace rubble::io
