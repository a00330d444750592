#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/fe/frame.h"
#include "core/scenario/scenario.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// A scenario as {"settings": {key: value}, "regrouping": [steps]}: only settings that differ from the defaults, by their keys in
/// the parameter table. Throws UsageError where a value is out of its range or not finite.
nlohmann::json scenarioJson(const Scenario& scenario);
/// Reads the two keys that scenarioJson() writes out of an object that may hold others. Throws ParseError.
Scenario scenarioFromJson(const JsonCursor& object);

nlohmann::json frameJson(const Frame& frame);
Frame frameFromJson(const JsonCursor& object);

}  // namespace rubble::io
