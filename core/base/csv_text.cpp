#include "core/base/csv_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace rubble {

std::string exactNumber(double number) {
    if (!std::isfinite(number)) {
        return {};
    }
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    assert(end.ec == std::errc{});
    return {buffer.data(), end.ptr};
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c;
        if (c == '"') {
            quoted += c;
        }
    }
    return quoted + '"';
}

}  // namespace rubble
