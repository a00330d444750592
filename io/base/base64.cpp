#include "io/base/base64.h"

#include <algorithm>
#include <array>

namespace rubble::io {

namespace {

constexpr int noDigit = -1;

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<int, 256> base64Digits = [] {
    std::array<int, 256> digits{};
    digits.fill(noDigit);
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
    }
    return digits;
}();

}  // namespace

std::string encodeBase64(std::string_view bytes) {
    std::string text;
    text.reserve(base64Length(bytes.size()));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t b = 0; b < 3; ++b) {
            group = group << 8 | (b < left ? static_cast<unsigned char>(bytes[i + b]) : 0u);
        }
        for (std::size_t d = 0; d < 4; ++d) {
            text.push_back(d <= left ? alphabet[group >> (18 - 6 * d) & 0x3fu] : '=');
        }
    }
    return text;
}

bool decodeBase64(std::string_view text, std::string& bytes) {
    bytes.clear();
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i + 4 <= text.size(); i += 4) {
        unsigned group = 0;
        int digits = 0;
        for (std::size_t d = 0; d < 4; ++d) {
            const int digit = base64Digits[static_cast<unsigned char>(text[i + d])];
            if (digit == noDigit && (text[i + d] != '=' || d < 2)) {
                return false;
            }
            digits += digit == noDigit ? 0 : 1;
            group = group << 6 | static_cast<unsigned>(std::max(digit, 0));
        }
        for (int b = 0; b < digits - 1; ++b) {
            bytes.push_back(static_cast<char>(group >> (16 - 8 * b) & 0xffu));
        }
    }
    return true;
}

}  // namespace rubble::io
