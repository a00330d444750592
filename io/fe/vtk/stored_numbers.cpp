#include "io/fe/vtk/stored_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace rubble::io {

namespace {

static_assert(std::endian::native == std::endian::little);

bool isBlank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f';
}

void skipBlanks(std::string_view& text) {
    std::size_t blanks = 0;
    while (blanks < text.size() && isBlank(text[blanks])) {
        ++blanks;
    }
    text.remove_prefix(blanks);
}

std::int64_t wholeOf(double value) {
    return std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : std::numeric_limits<std::int64_t>::min();
}

template <class To, class From>
To converted(From value) {
    if constexpr (std::is_floating_point_v<From> && !std::is_floating_point_v<To>) {
        return wholeOf(static_cast<double>(value));
    } else {
        return static_cast<To>(value);
    }
}

template <class From, class To>
std::vector<To> decoded(std::string_view bytes, bool bigEndian) {
    std::vector<To> values(bytes.size() / sizeof(From));
    std::array<char, sizeof(From)> raw{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::memcpy(raw.data(), bytes.data() + i * sizeof(From), sizeof(From));
        if (bigEndian) {
            std::reverse(raw.begin(), raw.end());
        }
        values[i] = converted<To>(std::bit_cast<From>(raw));
    }
    return values;
}

template <class To>
std::vector<To> numbersIn(std::string_view bytes, NumberType type, bool big) {
    if (type.kind == NumberType::Kind::Real) {
        return type.bytes == sizeof(float) ? decoded<float, To>(bytes, big) : decoded<double, To>(bytes, big);
    }
    const bool isSigned = type.kind == NumberType::Kind::Signed;
    switch (type.bytes) {
        case 1:
            return isSigned ? decoded<std::int8_t, To>(bytes, big) : decoded<std::uint8_t, To>(bytes, big);
        case 2:
            return isSigned ? decoded<std::int16_t, To>(bytes, big) : decoded<std::uint16_t, To>(bytes, big);
        case 4:
            return isSigned ? decoded<std::int32_t, To>(bytes, big) : decoded<std::uint32_t, To>(bytes, big);
        default:
            return isSigned ? decoded<std::int64_t, To>(bytes, big) : decoded<std::uint64_t, To>(bytes, big);
    }
}

}  // namespace

std::vector<double> realsIn(std::string_view bytes, NumberType type, bool bigEndian) {
    return numbersIn<double>(bytes, type, bigEndian);
}

std::vector<std::int64_t> integersIn(std::string_view bytes, NumberType type, bool bigEndian) {
    return numbersIn<std::int64_t>(bytes, type, bigEndian);
}

bool takeReal(std::string_view& text, double& value) {
    skipBlanks(text);
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    // What is too large or too small for a double is a number all the same.
    if (error == std::errc::result_out_of_range) {
        const std::string_view number(begin, static_cast<std::size_t>(end - begin));
        const bool tiny = number.find("e-") != std::string_view::npos || number.find("E-") != std::string_view::npos;
        value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    const bool whole = error != std::errc::invalid_argument && (end == text.data() + text.size() || isBlank(*end));
    if (whole) {
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return whole;
}

bool takeInteger(std::string_view& text, std::int64_t& value) {
    skipBlanks(text);
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error == std::errc{} && (end == text.data() + text.size() || isBlank(*end))) {
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return true;
    }
    double real = 0.0;
    const bool isNumber = takeReal(text, real);
    if (isNumber) {
        value = wholeOf(real);
    }
    return isNumber;
}

std::string_view takeWord(std::string_view& text) {
    skipBlanks(text);
    std::size_t length = 0;
    while (length < text.size() && !isBlank(text[length])) {
        ++length;
    }
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

}  // namespace rubble::io
