#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/finding.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// Messages and findings as JSON, with their patterns and arguments, so that they can be translated where they are read. Reading
/// functions throw ParseError with the place.
nlohmann::json messageJson(const Message& message);
Message messageFromJson(const JsonCursor& object);

nlohmann::json findingsJson(const Findings& findings);
Findings findingsFromJson(const JsonCursor& list);

}  // namespace rubble::io
