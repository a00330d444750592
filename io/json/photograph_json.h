#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/scenario/photograph.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// The photographs of a case as they stand in its file, and back. Reading throws ParseError with the place.
nlohmann::json photographsJson(const std::vector<Photograph>& photographs);
std::vector<Photograph> photographsFromJson(const JsonCursor& list);

}  // namespace rubble::io
