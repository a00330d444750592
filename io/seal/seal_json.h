#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_cursor.h"
#include "io/seal/seal_statement.h"

namespace rubble::io {

// What statement and records say alike. Reading throws ParseError.
nlohmann::json sealedInputJson(const SealedInput& input);
SealedInput sealedInputFrom(const JsonCursor& row);
nlohmann::json sealedRunJson(const SealedRun& run);
SealedRun sealedRunFrom(const JsonCursor& row);

}  // namespace rubble::io
