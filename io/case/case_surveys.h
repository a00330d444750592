#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/scenario/case.h"
#include "io/site/site_place.h"
#include "io/site/surveys/named_points.h"

namespace rubble::io {

/// What a file of a survey holds, by who can read it: measured points, an outline, a cloud, else heights. Throws as these.
SurveyKind surveyKindOf(const std::string& path, const CloudRequest& read);

/// The place among the inputs of a case of a survey, which is added, with an id of its own, its SHA-256 and what it holds, if it is
/// none of them; of one that is what it holds is kept. A scan of ours says which instant of a run it shows.
/// @param casePath  the file that inputs are relative to. Throws WorldError (cannot be read).
std::size_t takeSurvey(Case& theCase, const std::string& casePath, const std::string& path);

/// The named points of all files that a case holds as control, in metres of easting, northing and height, moved by the registration
/// of their file; a name that several have counts once, as the first file has it, which is a finding. Empty: it holds none.
/// @param place  of the case. Throws as readNamedPoints().
std::vector<NamedPoint> controlPointsOfCase(const Case& theCase, const std::string& casePath, const SitePlace& place,
                                            Findings& findings, const Execution& execution);

/// Of a survey of which a case does not keep what it holds: that its name tells otherwise than its content does. Empty: it is as
/// its name says, it is kept, or it cannot be read, which is said where it is compared. Throws WorldError.
Findings checkKind(const CaseInput& survey, const std::string& path);

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
