#pragma once

#include "core/validation/validation_record.h"
#include "io/json/json_value.h"

namespace rubble::io {

/// {id, title, source, licence, folder, bodies, variants [...]} as `rubble-cli validate --json` has it; the manual lists the keys.
JsonValue validationJson(const ValidationRecord& record);

/// The same back. Throws ParseError. @param file  that the text is of
ValidationRecord validationFromText(const std::string& text, const std::string& file);

}  // namespace rubble::io
