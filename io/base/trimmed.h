#pragma once

#include <string_view>

namespace rubble::io {

/// The part of a text between the blanks at its ends. Lives as long as the text.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\n\v\f\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

}  // namespace rubble::io
