#include "io/json/evidence_settings_json.h"

#include <nlohmann/json.hpp>

#include "io/json/json_cursor.h"

namespace rubble::io {

namespace {

double lengthIn(const JsonCursor& cursor, double least, double most) {
    const double length = cursor.number();
    if (!(length >= least && length <= most)) {
        cursor.fail("a length from " + std::to_string(least) + " to " + std::to_string(most) + " m");
    }
    return length;
}

}  // namespace

nlohmann::json evidenceSettingsJson(const EvidenceSettings& settings) {
    return {{"cell_m", settings.cell},
            {"least_height_m", settings.leastHeight},
            {"registration", surveyFitName(settings.fit)},
            {"surveys_live_structure", settings.surveysWithFallen},
            {"photographs_live_structure", settings.photographsWithFallen}};
}

EvidenceSettings evidenceSettingsFromJson(const JsonCursor& cursor) {
    cursor.allowOnly({"cell_m", "least_height_m", "registration", "surveys_live_structure", "photographs_live_structure"});
    EvidenceSettings settings;
    settings.cell = lengthIn(cursor["cell_m"], 0.05, 10.0);
    settings.leastHeight = lengthIn(cursor["least_height_m"], 0.0, 5.0);
    const std::optional<SurveyFit> fit = surveyFitNamed(cursor["registration"].text());
    if (!fit) {
        cursor["registration"].fail("none, ground or debris");
    }
    settings.fit = *fit;
    settings.surveysWithFallen = cursor["surveys_live_structure"].flag();
    settings.photographsWithFallen = cursor["photographs_live_structure"].flag();
    return settings;
}

}  // namespace rubble::io
