#pragma once

#include <cstddef>
#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// The place among the inputs of a case of a survey, which is added, with an id of its own and its SHA-256, if it is none of them.
/// @param casePath  the file that inputs are relative to. Throws WorldError (cannot be read).
std::size_t takeSurvey(Case& theCase, const std::string& casePath, const std::string& path);

}  // namespace rubble::io
