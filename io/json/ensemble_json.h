#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scenario/ensemble.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// What an ensemble varies as it stands in a case file, and back. Reading throws ParseError with the place.
nlohmann::json ensembleJson(const EnsembleSettings& settings);
EnsembleSettings ensembleFromJson(const JsonCursor& cursor);

}  // namespace rubble::io
