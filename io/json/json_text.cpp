#include "io/json/json_text.h"

#include <nlohmann/json.hpp>

namespace rubble::io {

using nlohmann::json;

std::string jsonText(const json& value) {
    return value.dump(1, ' ', false, json::error_handler_t::replace);
}

std::string jsonLine(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace rubble::io
