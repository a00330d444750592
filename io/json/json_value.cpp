#include "io/json/json_value.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

namespace rubble::io {

using Ordered = nlohmann::ordered_json;

struct JsonValuePrinter {
    static Ordered ordered(const JsonValue& value) {
        using Kind = JsonValue::Kind;
        switch (value.m_kind) {
            case Kind::Null:
                return nullptr;
            case Kind::Flag:
                return value.m_natural != 0;
            case Kind::Integer:
                return static_cast<std::int64_t>(value.m_natural);
            case Kind::Natural:
                return value.m_natural;
            case Kind::Real:
                return value.m_real;
            case Kind::Text:
                return value.m_text;
            case Kind::Array: {
                Ordered list = Ordered::array();
                for (const JsonValue& item : value.m_items) {
                    list.push_back(ordered(item));
                }
                return list;
            }
            case Kind::Object: {
                Ordered object = Ordered::object();
                for (std::size_t i = 0; i < value.m_items.size(); ++i) {
                    object[value.m_keys[i]] = ordered(value.m_items[i]);
                }
                return object;
            }
        }
        return nullptr;
    }
};

JsonValue::JsonValue(std::string text) : m_kind(Kind::Text), m_text(std::move(text)) {}

JsonValue::JsonValue(std::string_view text) : m_kind(Kind::Text), m_text(text) {}

JsonValue::JsonValue(const char* text) : m_kind(Kind::Text), m_text(text) {}

JsonValue::JsonValue(std::initializer_list<JsonValue> items) {
    const bool pairs = std::all_of(items.begin(), items.end(), [](const JsonValue& item) {
        return item.m_kind == Kind::Array && item.m_items.size() == 2 && item.m_items[0].m_kind == Kind::Text;
    });
    if (!pairs) {
        take(items);
        return;
    }
    m_kind = Kind::Object;
    for (const JsonValue& item : items) {
        (*this)[item.m_items[0].m_text] = item.m_items[1];
    }
}

JsonValue::JsonValue(const JsonValue& other) = default;
JsonValue::JsonValue(JsonValue&& other) noexcept = default;
JsonValue::~JsonValue() = default;

JsonValue& JsonValue::operator=(JsonValue other) noexcept {
    m_kind = other.m_kind;
    m_real = other.m_real;
    m_natural = other.m_natural;
    m_text = std::move(other.m_text);
    m_items = std::move(other.m_items);
    m_keys = std::move(other.m_keys);
    return *this;
}

JsonValue JsonValue::array() {
    return array({});
}

JsonValue JsonValue::array(std::initializer_list<JsonValue> items) {
    JsonValue list;
    list.take(items);
    return list;
}

JsonValue JsonValue::object() {
    JsonValue empty;
    empty.m_kind = Kind::Object;
    return empty;
}

JsonValue& JsonValue::operator[](std::string_view key) {
    if (m_kind == Kind::Null) {
        m_kind = Kind::Object;
    }
    assert(m_kind == Kind::Object);
    const auto found = std::find(m_keys.begin(), m_keys.end(), key);
    if (found != m_keys.end()) {
        return m_items[static_cast<std::size_t>(found - m_keys.begin())];
    }
    m_keys.emplace_back(key);
    return m_items.emplace_back();
}

void JsonValue::push_back(JsonValue item) {
    if (m_kind == Kind::Null) {
        m_kind = Kind::Array;
    }
    assert(m_kind == Kind::Array);
    m_items.push_back(std::move(item));
}

std::string JsonValue::text() const {
    return JsonValuePrinter::ordered(*this).dump(2, ' ', false, Ordered::error_handler_t::replace);
}

void JsonValue::take(std::initializer_list<JsonValue> items) {
    m_kind = Kind::Array;
    m_items.assign(items.begin(), items.end());
}

}  // namespace rubble::io
