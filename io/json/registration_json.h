#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/scenario/registration.h"
#include "core/scenario/removal.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// How a survey lies in a case, as it stands in the file, and back. Reading throws ParseError with the place.
nlohmann::json registrationJson(const Registration& registration);
Registration registrationFromJson(const JsonCursor& object);

/// Date and time; an error if it is none.
std::string clockTimeFromJson(const JsonCursor& text);

/// What was removed, and back.
nlohmann::json removalsJson(const std::vector<Removal>& removals);
std::vector<Removal> removalsFromJson(const JsonCursor& list);

}  // namespace rubble::io
