#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::io {

/// How the numbers of an array lie in a file.
struct NumberType {
    enum class Kind : std::uint8_t { Signed, Unsigned, Real };
    Kind kind = Kind::Real;
    std::size_t bytes = sizeof(double);
};

/// Values of numbers as they lie in bytes, in order; what is left behind the last whole number is not read. A real number that no
/// whole number can hold becomes the least one, which no table has an entry for.
std::vector<double> realsIn(std::string_view bytes, NumberType type, bool bigEndian);
std::vector<std::int64_t> integersIn(std::string_view bytes, NumberType type, bool bigEndian);

/// Takes the next number off a text, blanks before it included. @return false if there is none: the text then begins with what is
/// there instead, or is empty
bool takeReal(std::string_view& text, double& value);
bool takeInteger(std::string_view& text, std::int64_t& value);
/// The first word of a text, without it and the blanks before it; empty at the end.
std::string_view takeWord(std::string_view& text);

}  // namespace rubble::io
