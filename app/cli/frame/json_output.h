#pragma once

#include <functional>
#include <optional>

#include "app/cli/frame/session.h"
#include "core/base/finding.h"
#include "core/clusters/sizing.h"
#include "io/json/json_value.h"

namespace rubble::cli {

/// Keys stay in the order in which the manual lists them.
using Json = io::JsonValue;

/// Writes the one object of --json. Throws WorldError if the output does not take it.
void printJson(Session& session, const Json& object);

/// [{id, count, what, example, remedy}]
/// @param say  in which language
Json findingsJson(const Findings& findings, const std::function<std::string(const Message&)>& say = englishText);
/// The same with one more; unset: none.
Json findingsJson(Findings findings, const std::optional<Finding>& more);

/// Adds the keys that size and run share: grid, multiple, bounds, stopped_by, clamped_by and what belongs to them.
void addSizingJson(Json& object, const Sizing& sizing);

/// {x, y, z} of one value for each axis.
template <class Get>
Json axesJson(const Sizing& sizing, Get get) {
    Json axes;
    axes["x"] = get(sizing.axis[0]);
    axes["y"] = get(sizing.axis[1]);
    axes["z"] = get(sizing.axis[2]);
    return axes;
}

}  // namespace rubble::cli
