#pragma once

#include <optional>
#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// Adds a photograph and its file to a case, with what its file says; a cropped one has its principal point found. Returns the id
/// of the file, which no other input has; nothing if the case has a photograph with this content already.
/// @param casePath  the file that inputs are relative to
std::optional<std::string> addPhotograph(Case& theCase, const std::string& casePath, const std::string& path,
                                         const PhotoFacts& facts, const std::string& sha256);

}  // namespace rubble::io
