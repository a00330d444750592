#include "core/base/message.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace rubble {

namespace {

std::string text(const Argument& argument) {
    struct Visitor {
        std::string operator()(const std::string& value) const { return value; }
        std::string operator()(std::int64_t value) const { return englishInteger(value); }
        std::string operator()(double value) const { return englishNumber(value); }
    };
    std::string result = std::visit(Visitor{}, argument.value);
    if (!argument.unit.empty()) {
        result += argument.unit == "%" ? " %" : " " + argument.unit;
    }
    return result;
}

}  // namespace

std::string englishInteger(std::int64_t number) {
    // Through the unsigned magnitude, so that the smallest integer has one too.
    const bool negative = number < 0;
    std::string digits = std::to_string(negative ? ~static_cast<std::uint64_t>(number) + 1 : static_cast<std::uint64_t>(number));
    for (std::size_t i = digits.size(); i > 3; i -= 3) {
        digits.insert(i - 3, 1, ',');
    }
    return negative ? "-" + digits : digits;
}

std::string englishNumber(double number) {
    number += 0.0;  // no minus zero
    if (!std::isfinite(number)) {
        return std::isnan(number) ? "not a number" : (number > 0 ? "infinite" : "minus infinite");
    }
    const double magnitude = std::abs(number);
    if (magnitude >= 1000.0 && magnitude < 1e15) {
        return englishInteger(std::llround(number));
    }
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::general, 4);
    return {buffer.data(), result.ptr};
}

std::string englishText(const Message& message) {
    std::string result;
    const std::string& pattern = message.pattern;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t close = pattern[i] == '{' ? pattern.find('}', i) : std::string::npos;
        std::size_t index = 0;
        const char* first = pattern.data() + i + 1;
        const bool placeholder = close != std::string::npos && close > i + 1 &&
                                 std::from_chars(first, pattern.data() + close, index).ptr == pattern.data() + close;
        if (placeholder && index < message.arguments.size()) {
            result += text(message.arguments[index]);
            i = close;
        } else {
            result += pattern[i];
        }
    }
    return result;
}

}  // namespace rubble
