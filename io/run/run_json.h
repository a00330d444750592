#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/evidence/cautions.h"
#include "core/scenario/case.h"
#include "io/json/findings_json.h"
#include "io/json/json_cursor.h"
#include "io/json/json_text.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// What a run file keeps as JSON text: everything that is not a long list of numbers. Reading functions throw ParseError with the
/// place.
nlohmann::json sizingJson(const Sizing& sizing);
Sizing sizingFromJson(const JsonCursor& object);

/// Without the outcomes of the fragments.
nlohmann::json resultJson(const SimulationResult& result);
SimulationResult resultFromJson(const JsonCursor& object);

nlohmann::json breachJson(const HealthBreach& breach);
HealthBreach breachFromJson(const JsonCursor& object);

/// Without clusters and members.
nlohmann::json clusteringJson(const Clustering& clustering);
Clustering clusteringFromJson(const JsonCursor& object);

/// A digest of 32 hexadecimal digits.
Digest digestFromJson(const JsonCursor& cursor);

nlohmann::json originJson(const RunOrigin& origin);
RunOrigin originFromJson(const JsonCursor& object);

/// List of {key, grade, text}.
nlohmann::json cautionsJson(const std::vector<Caution>& cautions);

}  // namespace rubble::io
