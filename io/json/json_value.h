#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rubble::io {

/// A JSON value to be written: keys stay in the order in which they came. Braces make what they would mean in JSON: a list of pairs
/// that begin with a text is an object, any other list an array. It is cheap to include: the library that prints it stays in
/// json_value.cpp.
class JsonValue {
public:
    JsonValue() noexcept = default;  ///< null
    JsonValue(std::nullptr_t) noexcept {}
    JsonValue(std::string text);
    JsonValue(std::string_view text);
    JsonValue(const char* text);
    template <class Number>
        requires std::is_arithmetic_v<Number>
    JsonValue(Number number) {
        if constexpr (std::same_as<Number, bool>) {
            m_kind = Kind::Flag;
            m_natural = number ? 1 : 0;
        } else if constexpr (std::floating_point<Number>) {
            m_kind = Kind::Real;
            m_real = static_cast<double>(number);
        } else if constexpr (std::signed_integral<Number>) {
            m_kind = Kind::Integer;
            m_natural = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
        } else {
            m_kind = Kind::Natural;
            m_natural = number;
        }
    }
    /// An array of what the range holds.
    template <class Range>
        requires std::ranges::input_range<const Range> && (!std::convertible_to<const Range&, std::string_view>) &&
                 (!std::same_as<std::remove_cvref_t<Range>, JsonValue>)
    JsonValue(const Range& range) : m_kind(Kind::Array) {
        for (const auto& item : range) {
            push_back(JsonValue(item));
        }
    }
    JsonValue(std::initializer_list<JsonValue> items);
    JsonValue(const JsonValue& other);
    JsonValue(JsonValue&& other) noexcept;
    JsonValue& operator=(JsonValue other) noexcept;
    ~JsonValue();

    static JsonValue array();
    static JsonValue array(std::initializer_list<JsonValue> items);
    static JsonValue object();

    /// The value of a key, null at first. Null becomes an object; anything else must be one.
    JsonValue& operator[](std::string_view key);
    /// Null becomes an array; anything else must be one.
    void push_back(JsonValue item);

    /// As text over several lines, indented by two. Numbers that are not finite become null; bytes that are no UTF-8, as names in
    /// files may hold them, are replaced rather than refused.
    std::string text() const;

private:
    enum class Kind : std::uint8_t { Null, Flag, Integer, Natural, Real, Text, Array, Object };
    friend struct JsonValuePrinter;

    void take(std::initializer_list<JsonValue> items);

    Kind m_kind = Kind::Null;
    double m_real = 0.0;
    std::uint64_t m_natural = 0;  ///< flags and integers; those below zero in two's complement
    std::string m_text;
    std::vector<JsonValue> m_items;
    std::vector<std::string> m_keys;  ///< of an object, beside its items
};

}  // namespace rubble::io
