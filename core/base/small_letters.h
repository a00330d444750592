#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rubble {

/// A text with its Latin capitals made small, whatever the locale; other bytes stay. For names that people and programs write in
/// either case: endings of files, headings, units.
inline std::string inSmallLetters(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return small;
}

}  // namespace rubble
