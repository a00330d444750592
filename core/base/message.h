#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rubble {

/// One value inside a message: a text, an integer or a number with its unit.
struct Argument {
    std::variant<std::string, std::int64_t, double> value;
    std::string unit;

    Argument(std::string text) : value(std::move(text)) {}
    Argument(std::string_view text) : value(std::string(text)) {}
    Argument(const char* text) : value(std::string(text)) {}
    Argument(int number) : value(static_cast<std::int64_t>(number)) {}
    Argument(std::int64_t number) : value(number) {}
    Argument(std::size_t number) : value(static_cast<std::int64_t>(number)) {}
    Argument(double number, std::string_view unit_ = {}) : value(number), unit(unit_) {}
};

/// Text for people, before translation: a stable id, an English pattern with {0}, {1}, ... and its arguments.
/// Core and io make messages; the command line prints englishText(), the window translates the pattern by id.
struct Message {
    std::string id;
    std::string pattern;
    std::vector<Argument> arguments;

    bool empty() const { return pattern.empty(); }
};

/// The pattern with its arguments put in: integers grouped by thousands, numbers to four significant digits, units after a space.
std::string englishText(const Message& message);

/// A number as englishText() prints it (for tables that must agree with the sentences).
std::string englishNumber(double number);
/// An integer with thousands grouped by commas.
std::string englishInteger(std::int64_t number);

}  // namespace rubble
