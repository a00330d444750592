#include "tests/support/places.h"

namespace rubble {

namespace {

std::string below(const char* root, std::string_view relative) {
    return relative.empty() ? std::string(root) : std::string(root) + "/" + std::string(relative);
}

}  // namespace

std::string sourcePath(std::string_view relative) {
    return below(RUBBLE_SOURCE_DIR, relative);
}

std::string buildPath(std::string_view relative) {
    return below(RUBBLE_BINARY_DIR, relative);
}

}  // namespace rubble
