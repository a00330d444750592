#pragma once

#include "core/evidence/surveys/survey_comparison.h"

namespace rubble {

inline constexpr double apartLeast = 2.0;   ///< m, or two cells: what lies farther from simulated debris is apart from it
inline constexpr double apartShare = 0.05;  ///< of the surveyed debris: from here on it is much

/// What lies outside of the scope, of either side. @param surveyed  before what is not compared was taken out
LeftOutDebris leftOutOf(const SurveyComparison& made, const CellGrid& surveyed);

/// Cut, fill and net volume of the surveyed heights that are compared, from the level of detection on.
SurveyVolumes volumesOf(const SurveyComparison& made);

/// Patches of surveyed debris that come nowhere near the simulated debris. @param distances  in cells, to the latter
ApartDebris apartDebris(const SurveyComparison& made, const std::vector<double>& distances);

/// What becomes of the simulated debris when it is surveyed as the real one was. @param seen  as seenOn() gives it
SeenDebris seenMeasures(const SurveyComparison& made, const CellGrid& seen);

/// Says what stands out in these measures.
void findInMeasures(SurveyComparison& made, const std::string& survey);

}  // namespace rubble
