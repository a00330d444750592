#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scenario/site.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

nlohmann::json siteJson(const Site& site);
/// Throws ParseError.
Site siteFromJson(const JsonCursor& object);

}  // namespace rubble::io
