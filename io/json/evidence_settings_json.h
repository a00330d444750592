#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scenario/evidence_settings.h"

namespace rubble::io {

class JsonCursor;

/// How the evidence of a case is held against its runs. Lengths in m.
nlohmann::json evidenceSettingsJson(const EvidenceSettings& settings);
/// Throws ParseError for keys and values that it has not.
EvidenceSettings evidenceSettingsFromJson(const JsonCursor& cursor);

}  // namespace rubble::io
