#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rubble::io {

/// Characters that so many bytes take in base64.
inline std::uint64_t base64Length(std::uint64_t bytes) {
    return (bytes + 2) / 3 * 4;
}

/// Bytes as base64 (RFC 4648), filled up with '='.
std::string encodeBase64(std::string_view bytes);

/// Bytes of base64 (RFC 4648) in groups of four; the last may be filled up with '='. What is left behind the last whole group is
/// not read. @return false where a character is none of the alphabet
bool decodeBase64(std::string_view text, std::string& bytes);

}  // namespace rubble::io
