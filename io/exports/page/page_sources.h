#pragma once

#include <string_view>

namespace rubble::io {

/// The page without its data, as resources/page has it: places for what is put in are {{name}}.
std::string_view pageFrame();
std::string_view pageStyle();
/// What runs in the head, before anything is laid out.
std::string_view pageOpening();
/// All other scripts, one behind the other.
std::string_view pageScript();

}  // namespace rubble::io
