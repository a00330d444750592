#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Parses JSON text. Throws ParseError with line, column and byte for broken text, and for a key that stands twice in one object.
/// @param file  what to call it in errors
nlohmann::json parseJson(std::string_view text, const std::string& file);

/// A number as JSON: finite ones shortest and exact, others as "nan", "inf" and "-inf", which JSON itself lacks.
nlohmann::json jsonNumber(double number);
nlohmann::json jsonVector(const Vec3& v);

/// A value inside a JSON document that knows its file and its place, so that every complaint names both. Holds a reference: the
/// document must outlive it. All reading members throw ParseError.
class JsonCursor {
public:
    JsonCursor(const nlohmann::json& value, std::string file, std::string place = {});

    /// The member of an object; an error if it is missing.
    JsonCursor operator[](std::string_view key) const;
    bool has(std::string_view key) const;
    /// An error if the object has a key that is not listed.
    void allowOnly(std::initializer_list<std::string_view> keys) const;
    std::vector<JsonCursor> elements() const;
    std::vector<std::pair<std::string, JsonCursor>> members() const;

    std::string text() const;
    bool flag() const;
    std::int64_t integer() const;
    double number() const;     ///< finite
    double anyNumber() const;  ///< also "nan", "inf", "-inf"
    Vec3 vector() const;
    const nlohmann::json& value() const { return *m_value; }

    /// Refuses what stands here: "expected ..., found ...".
    [[noreturn]] void fail(std::string_view expected) const;
    /// Refuses what stands here for a reason of its own.
    [[noreturn]] void refuse(std::string_view reason, std::string_view remedy) const;

private:
    const nlohmann::json* m_value;
    std::string m_file;
    std::string m_place;
};

}  // namespace rubble::io
