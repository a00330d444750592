#include "core/evidence/surveys/stated_survey.h"

#include <cstdint>

#include "core/base/csv_text.h"
#include "core/base/error.h"

namespace rubble {

std::string clockTimeFrom(const std::string& text) {
    std::string whole = text;
    constexpr std::size_t day = 10;
    constexpr std::size_t minutes = 16;
    constexpr std::size_t seconds = 19;
    if (whole.size() != minutes && whole.size() != seconds) {
        return {};
    }
    if (whole[day] == 'T') {
        whole[day] = ' ';
    }
    if (whole.size() == minutes) {
        whole += ":00";
    }
    return clockTime(whole);
}

SurveyScope scopeWhenTaken(const Case& theCase, const CaseInput& survey, Findings& findings) {
    SurveyScope scope = survey.scope;
    std::int64_t gone = 0;
    std::int64_t open = 0;
    for (const Removal& removal : theCase.removals) {
        if (survey.taken.empty()) {
            ++open;
        } else if (removal.time <= survey.taken) {
            scope.leftOut.polygons.insert(scope.leftOut.polygons.end(), removal.area.polygons.begin(), removal.area.polygons.end());
            ++gone;
        }
    }
    if (gone > 0) {
        findings.add({"survey.removed", "places whose debris had been removed before {0} are not compared", {survey.taken}},
                     {"survey.removed.remedy", "none is needed", {}}, survey.path, gone);
    }
    if (open > 0) {
        findings.add({"survey.removal_unknown", "debris was removed from places, and when the survey was taken is not known", {}},
                     {"survey.removal_unknown.remedy", "say when the survey was taken; until then these places are compared", {}},
                     survey.path, open);
    }
    return scope;
}

void takeStated(SurveySettings& settings, const Case& theCase, const CaseInput& survey, Findings& findings) {
    const auto take = [](auto& asked, const auto& said) {
        if (!asked) {
            asked = said;
        }
    };
    take(settings.showsFallen, survey.showsFallen);
    take(settings.noise, survey.noise);
    take(settings.groundNoise, survey.groundNoise);
    take(settings.offsetError, survey.offsetError);
    if (survey.registration) {
        take(settings.offsetError, survey.registration->error);
    }
    settings.scope = scopeWhenTaken(theCase, survey, findings);
}

SurveySettings surveySettingsOf(const Case& theCase) {
    SurveySettings settings;
    settings.cell = theCase.evidence.cell;
    settings.leastHeight = theCase.evidence.leastHeight;
    settings.fit = theCase.evidence.fit;
    settings.withFallen = theCase.evidence.surveysWithFallen;
    return settings;
}

void checkShowsDebris(const CaseInput& survey) {
    if (survey.before) {
        throw UsageError({"survey.before", "{0} was taken before the collapse: it shows no debris", {survey.path}},
                         {"survey.before.remedy", "Take it as the terrain, or say that it was taken afterwards.", {}});
    }
    if (survey.held == PointsHeld::Control) {
        throw UsageError({"survey.control", "The points of {0} are held as control: they show no debris", {survey.path}},
                         {"survey.control.remedy", "Hold them as an outline or for sections in the list of evidence.", {}});
    }
}

void checkShowsRest(const CaseInput& survey) {
    if (survey.instant) {
        throw UsageError({"survey.not_at_rest",
                          "{0} shows the collapse at {1} s: members keep their debris at rest",
                          {survey.path, exactNumber(*survey.instant)}},
                         {"survey.not_at_rest.remedy", "Leave it out here, and hold single runs against it as a survey.", {}});
    }
}

}  // namespace rubble
