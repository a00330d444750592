#pragma once

#include <cstddef>
#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// What a file of a survey holds, by who can read it: an outline, points (holdsCloud()), else heights. Throws as these.
SurveyKind surveyKindOf(const std::string& path, const CloudRequest& read);

/// The place among the inputs of a case of a survey, which is added, with an id of its own, its SHA-256 and what it holds, if it is
/// none of them.
/// @param casePath  the file that inputs are relative to. Throws WorldError (cannot be read).
std::size_t takeSurvey(Case& theCase, const std::string& casePath, const std::string& path);

}  // namespace rubble::io
