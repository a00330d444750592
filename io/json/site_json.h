#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scenario/cloud_request.h"
#include "core/scenario/site.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

nlohmann::json siteJson(const Site& site);
/// Throws ParseError.
Site siteFromJson(const JsonCursor& object);

/// Adds how a cloud is read, as "crs" and "columns"; nothing of what is not stated. @param of  before both names
void putCloudRequest(nlohmann::json& object, const CloudRequest& read, const std::string& of = {});
/// Throws ParseError.
CloudRequest cloudRequestFromJson(const JsonCursor& object, const std::string& of = {});

}  // namespace rubble::io
