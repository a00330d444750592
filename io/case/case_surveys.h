#pragma once

#include <cstddef>
#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// What a file of a survey holds, by who can read it: measured points, an outline, a cloud, else heights. Throws as these.
SurveyKind surveyKindOf(const std::string& path, const CloudRequest& read);

/// The place among the inputs of a case of a survey, which is added, with an id of its own, its SHA-256 and what it holds, if it is
/// none of them.
/// @param casePath  the file that inputs are relative to. Throws WorldError (cannot be read).
std::size_t takeSurvey(Case& theCase, const std::string& casePath, const std::string& path);

/// Keeps how a survey, a terrain or surroundings are read, of a survey with what its file then holds, once they can be read so.
/// @param path  of its file Throws as openCloud(), UsageError (it is no cloud or table); the survey is then as it was.
void stateReading(CaseInput& survey, const std::string& path, const CloudRequest& read);

/// What a file leaves open of how it is read.
struct OpenReading {
    bool system = false;   ///< a cloud names none, and the case has one
    bool columns = false;  ///< of a table, which no heading names
    bool any() const { return system || columns; }
};
/// @param frame  of the case
OpenReading readingLeftOpen(const CaseInput& survey, const std::string& path, const Frame& frame);

}  // namespace rubble::io
