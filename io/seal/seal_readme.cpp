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
    const std::string commit(commitText());
    constexpr std::string_view before = ", sources ";
    const std::size_t from = statement.build.find(before);
    const std::size_t begin = from == std::string::npos ? statement.build.size() : from + before.size();
    putIn(text, "{{version}}", statement.version);
    putIn(text, "{{commit}}", commit.empty() ? "not named by this build" : commit);
    putIn(text, "{{sources}}", statement.build.substr(begin, statement.build.find(',', begin) - begin));
    putIn(text, "{{build}}", statement.build);
    return text;
}

}  // namespace rubble::io
