#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rubble::io {

/// What a JSON file that Rubble wrote for itself says at its head, and how large it can be.
struct JsonKind {
    const char* format;
    std::int64_t version;
    std::uintmax_t bytesMax;
};

/// Reads a file of a kind. Throws WorldError if it cannot be read, ParseError if it is too large, of another format or version, or
/// damaged; each names the file.
nlohmann::json readJsonDocument(const std::string& path, const JsonKind& kind);
/// The same of a text that was read already. @param name  what errors call it
nlohmann::json jsonDocumentFrom(const std::string& text, const std::string& name, const JsonKind& kind);

}  // namespace rubble::io
