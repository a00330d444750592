#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/scenario/case.h"
#include "io/site/survey_file.h"

namespace rubble {

class Session;
class Worker;

/// Reads the heights of a survey of the case in the background, for a dialog that asks where they lie; what fails is told.
/// @param registration  by which they are moved once they lie in the case's frame
/// @param usable  throws a UsageError where what was read from the path cannot be placed; runs in the background
/// @param ask  is given what was read, on the GUI thread; the caller outlives the worker
void readToPlace(Worker& worker, Session& session, const CaseInput& survey, const std::optional<Registration>& registration,
                 std::function<void(const io::SurveyInput& read, const std::string& path)> usable,
                 std::function<void(io::SurveyInput& read)> ask);

}  // namespace rubble
