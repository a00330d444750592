#pragma once

#include <string>
#include <string_view>

#include "widgets/render/basics/view.h"

namespace rubble::figures {

/// A view as JSON: versioned, sorted keys, numbers that read back to the same value.
std::string toJson(const render::View& view);

/// Reads what toJson() wrote. Missing keys keep their defaults; refuses newer versions.
/// @param source  file or place the text came from, for messages
/// Throws ParseError naming source, key and remedy.
render::View viewFromJson(std::string_view json, std::string_view source);

/// The same from a file. Throws WorldError if it cannot be read.
render::View viewFromFile(const std::string& path);

}  // namespace rubble::figures
