#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/error.h"

namespace rubble::cli {

/// An option was given a value that it does not know. @param offered  what it does know
UsageError wrongValue(std::string_view option, const std::string& value, std::string_view offered);

/// Splits "a,b,c"; an empty part stays empty.
std::vector<std::string> splitAtCommas(std::string_view text);

/// Reads a number that is the whole text, without blanks and with a point as decimal sign; false if it is none.
template <class Number>
bool parseNumber(std::string_view text, Number& number) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    return end.ec == std::errc{} && end.ptr == text.data() + text.size();
}

}  // namespace rubble::cli
