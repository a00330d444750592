#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rubble::io {

/// JSON as text for a file: sorted; bytes that are not UTF-8 (names of files may hold any) are replaced.
std::string jsonText(const nlohmann::json& value);
/// The same on one line.
std::string jsonLine(const nlohmann::json& value);

}  // namespace rubble::io
