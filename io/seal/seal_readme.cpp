#include "io/seal/seal_readme.h"

namespace rubble::io {

namespace {

void putIn(std::string& text, std::string_view place, const std::string& content) {
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + content.size())) {
        text.replace(at, place.size(), content);
    }
}

}  // namespace

std::string sealReadme(const SealStatement& statement) {
    std::string text(sealReadmeFrame());
    putIn(text, "{{sealed_at}}", statement.sealedAt);
    return text;
}

std::string buildReadme(const SealStatement& statement) {
    std::string text(buildReadmeFrame());
    putIn(text, "{{version}}", statement.version);
    putIn(text, "{{build}}", statement.build);
    return text;
}

}  // namespace rubble::io
