#include "core/scenario/evidence_settings.h"

#include <algorithm>

namespace rubble {

std::optional<SurveyFit> surveyFitNamed(std::string_view name) {
    const auto found = std::find(surveyFitNames.begin(), surveyFitNames.end(), name);
    return found != surveyFitNames.end() ? std::optional(static_cast<SurveyFit>(found - surveyFitNames.begin())) : std::nullopt;
}

}  // namespace rubble
