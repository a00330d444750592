#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/outline.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// Polygons as lists of rings of corners [m].
nlohmann::json outlineJson(const Outline& outline);
/// Throws ParseError, also for a polygon without a ring and a ring of fewer than three corners.
Outline outlineFromJson(const JsonCursor& polygons);

}  // namespace rubble::io
