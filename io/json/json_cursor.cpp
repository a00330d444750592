#include "io/json/json_cursor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"

namespace rubble::io {

using nlohmann::json;

namespace {

const Message syntaxRemedy{
    "io.json.syntax.remedy", "The file is damaged or was edited by hand: put it right there, or take the last good copy.", {}};

[[noreturn]] void failSyntax(std::string_view text, std::size_t byte, const std::string& file, std::string_view what) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column = 1 + before.size() - (lastBreak == std::string_view::npos ? 0 : lastBreak + 1);
    throw ParseError(Message{"io.json.syntax",
                             "{0}, line {1}, column {2} (byte {3}): {4}",
                             {file, static_cast<std::int64_t>(line), column, byte, what}},
                     syntaxRemedy);
}

// Refuses repeated keys, of which the parser would silently keep the last.
class KeyWatch {
public:
    explicit KeyWatch(const std::string& file) : m_file(file) {}
    bool operator()(int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) {
            m_keys.emplace_back();
        } else if (event == json::parse_event_t::object_end) {
            m_keys.pop_back();
        } else if (event == json::parse_event_t::key) {
            const auto key = parsed.get<std::string>();
            if (!m_keys.back().insert(key).second) {
                throw ParseError(Message{"io.json.repeated", "{0}: the key \"{1}\" stands twice in one object", {m_file, key}},
                                 Message{"io.json.repeated.remedy", "Remove one of the two.", {}});
            }
        }
        return true;
    }

private:
    const std::string& m_file;
    std::vector<std::set<std::string>> m_keys;
};

std::string kindOf(const json& value) {
    switch (value.type()) {
        case json::value_t::null:
            return "null";
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return "a list";
        case json::value_t::string:
            return "the text \"" + value.get<std::string>().substr(0, 60) + "\"";
        case json::value_t::boolean:
            return value.get<bool>() ? "true" : "false";
        default:
            return value.dump();
    }
}

}  // namespace

json parseJson(std::string_view text, const std::string& file) {
    try {
        return json::parse(text.begin(), text.end(), KeyWatch(file));
    } catch (const json::parse_error& error) {
        failSyntax(text, error.byte > 0 ? error.byte - 1 : 0, file,
                   error.byte > text.size() ? "the text ends too early" : "this is not valid JSON");
    } catch (const json::out_of_range&) {
        throw ParseError(Message{"io.json.range", "{0}: a number is too large", {file}}, syntaxRemedy);
    }
}

json jsonNumber(double number) {
    if (std::isfinite(number)) {
        return number;
    }
    return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

json jsonVector(const Vec3& v) {
    return json::array({jsonNumber(v.x()), jsonNumber(v.y()), jsonNumber(v.z())});
}

JsonCursor::JsonCursor(const json& value, std::string file, std::string place)
    : m_value(&value), m_file(std::move(file)), m_place(std::move(place)) {}

void JsonCursor::fail(std::string_view expected) const {
    throw ParseError(Message{"io.json.kind",
                             "{0}: at {1}: expected {2}, found {3}",
                             {m_file, m_place.empty() ? "the top" : m_place, expected, kindOf(*m_value)}},
                     Message{"io.json.kind.remedy", "Correct the value in the file, or take the last good copy.", {}});
}

void JsonCursor::refuse(std::string_view reason, std::string_view remedy) const {
    throw ParseError(Message{"io.json.refused", "{0}: at {1}: {2}", {m_file, m_place.empty() ? "the top" : m_place, reason}},
                     Message{"io.json.refused.remedy", "{0}", {remedy}});
}

JsonCursor JsonCursor::operator[](std::string_view key) const {
    if (!m_value->is_object()) {
        fail("an object");
    }
    const auto found = m_value->find(key);
    if (found == m_value->end()) {
        refuse("the key \"" + std::string(key) + "\" is missing", "Add it, or take the last good copy.");
    }
    return {*found, m_file, m_place + "/" + std::string(key)};
}

bool JsonCursor::has(std::string_view key) const {
    return m_value->is_object() && m_value->contains(key);
}

void JsonCursor::allowOnly(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, member] : members()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            std::string known;
            for (const std::string_view name : keys) {
                known += (known.empty() ? "" : ", ") + std::string(name);
            }
            member.refuse("this key is unknown here", "Remove it, or correct it to one of: " + known + ".");
        }
    }
}

std::vector<JsonCursor> JsonCursor::elements() const {
    if (!m_value->is_array()) {
        fail("a list");
    }
    std::vector<JsonCursor> result;
    result.reserve(m_value->size());
    for (std::size_t i = 0; i < m_value->size(); ++i) {
        result.emplace_back((*m_value)[i], m_file, m_place + "/" + std::to_string(i));
    }
    return result;
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
    if (!m_value->is_object()) {
        fail("an object");
    }
    std::vector<std::pair<std::string, JsonCursor>> result;
    for (const auto& [key, member] : m_value->items()) {
        result.emplace_back(key, JsonCursor(member, m_file, m_place + "/" + key));
    }
    return result;
}

std::string JsonCursor::text() const {
    if (!m_value->is_string()) {
        fail("a text");
    }
    return m_value->get<std::string>();
}

bool JsonCursor::flag() const {
    if (!m_value->is_boolean()) {
        fail("true or false");
    }
    return m_value->get<bool>();
}

std::int64_t JsonCursor::integer() const {
    const bool tooLarge = m_value->is_number_unsigned() &&
                          m_value->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (!m_value->is_number_integer() || tooLarge) {
        fail("a whole number");
    }
    return m_value->get<std::int64_t>();
}

double JsonCursor::number() const {
    if (!m_value->is_number()) {
        fail("a number");
    }
    return m_value->get<double>();
}

double JsonCursor::anyNumber() const {
    if (m_value->is_string()) {
        const auto name = m_value->get<std::string>();
        if (name == "nan") {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (name == "inf" || name == "-inf") {
            return (name == "inf" ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
        }
    }
    return number();
}

Vec3 JsonCursor::vector() const {
    const std::vector<JsonCursor> parts = elements();
    if (parts.size() != 3) {
        fail("a list of three numbers");
    }
    return {parts[0].anyNumber(), parts[1].anyNumber(), parts[2].anyNumber()};
}

}  // namespace rubble::io
