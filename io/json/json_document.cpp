#include "io/json/json_document.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

std::string contentOf(const std::string& path, const JsonKind& kind) {
    std::error_code failed;
    const bool regular = fs::is_regular_file(path, failed);
    const std::uintmax_t size = regular ? fs::file_size(path, failed) : 0;
    if (!failed && size > kind.bytesMax) {
        throw ParseError({"io.json.too_large",
                          "{0} has {1} bytes; a file of format {2} has {3} at most",
                          {path, static_cast<std::size_t>(size), kind.format, static_cast<std::size_t>(kind.bytesMax)}},
                         {"io.json.too_large.remedy", "Move it away, or put a good copy in its place.", {}});
    }
    std::ifstream in;
    if (regular && !failed) {
        in.open(path, std::ios::binary);
    }
    if (!in.is_open()) {
        failToRead(path);
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

nlohmann::json readJsonDocument(const std::string& path, const JsonKind& kind) {
    return jsonDocumentFrom(contentOf(path, kind), path, kind);
}

nlohmann::json jsonDocumentFrom(const std::string& text, const std::string& path, const JsonKind& kind) {
    nlohmann::json document = parseJson(text, path);
    const JsonCursor top(document, path);
    if (top["format"].text() != kind.format) {
        top["format"].fail(std::string("\"") + kind.format + "\"");
    }
    if (top["version"].integer() != kind.version) {
        throw ParseError({"io.json.version",
                          "{0} is of version {1}; this program reads version {2}",
                          {path, top["version"].integer(), kind.version}},
                         {"io.json.version.remedy", "Use the Rubble that wrote it, or move it away.", {}});
    }
    return document;
}

}  // namespace rubble::io
