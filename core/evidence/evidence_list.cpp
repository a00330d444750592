#include "core/evidence/evidence_list.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/small_letters.h"
#include "core/evidence/surveys/stated_survey.h"
#include "core/fe/control_points.h"

namespace rubble {

namespace {

constexpr double confidence = 1.96;
constexpr std::array<std::string_view, 11> heightEndings{".tif", ".tiff", ".asc", ".bil", ".img", ".hgt",
                                                         ".dt0", ".dt1",  ".dt2", ".xyz", ".grd"};
constexpr std::array<std::string_view, 9> cloudEndings{".las", ".laz", ".e57", ".ply", ".pcd", ".ptx", ".pts", ".csv", ".txt"};
constexpr std::array<std::string_view, 7> outlineEndings{".gpkg", ".geojson", ".json", ".shp", ".fgb", ".kml", ".dxf"};

/// What nobody looked into is told by the ending of its file.
EvidenceForm formByEnding(const std::string& path) {
    const std::string ending = inSmallLetters(path.substr(std::min(path.size(), path.rfind('.'))));
    for (const EvidenceForm form : {EvidenceForm::Cloud, EvidenceForm::Outline}) {
        const std::span<const std::string_view> endings = endingsOf(form);
        if (std::find(endings.begin(), endings.end(), ending) != endings.end()) {
            return form;
        }
    }
    return EvidenceForm::Heights;
}

Message instantOf(const std::optional<double>& instant) {
    return instant ? Message{"evidence.at", "the debris at {0}", {{*instant, "s"}}}
                   : Message{"evidence.at_rest", "the debris at rest", {}};
}

/// An outline shows debris as every other does.
void sayHeld(EvidenceRow& row, const CaseInput& input) {
    if (input.held == PointsHeld::Section) {
        row.says = {"evidence.measured", "measured heights, which sections are held against", {}};
    } else if (input.held == PointsHeld::Control) {
        row.says = {"evidence.control", "places by their names, for pairs of photographs; no debris", {}};
    } else if (input.instant) {
        row.says = {"evidence.edge_at", "the edge of the debris at {0}, from point to point", {{*input.instant, "s"}}};
    } else {
        row.says = {"evidence.edge", "the edge of the debris at rest, from point to point", {}};
    }
}

EvidenceRow surveyRow(const CaseInput& input) {
    EvidenceRow row{input.id, evidenceFormOf(input), input.path, input.taken, instantOf(input.instant)};
    row.byEnding = !input.kind;
    if (row.form == EvidenceForm::Measured) {
        row.held = input.held;
        sayHeld(row, input);
    }
    if (input.before) {
        row.says = {"evidence.before", "the site before the collapse", {}};
    }
    if (input.offsetError) {
        row.within = confidence * *input.offsetError;
    } else if (input.registration && input.registration->error) {
        row.within = confidence * *input.registration->error;
    }
    return row;
}

EvidenceRow photographRow(const CaseInput& input, const std::vector<Photograph>& photographs) {
    EvidenceRow row{input.id, EvidenceForm::Photograph, input.path, {}, {}};
    const auto found = std::find_if(photographs.begin(), photographs.end(),
                                    [&](const Photograph& photograph) { return photograph.input == input.id; });
    if (found == photographs.end()) {
        row.says = {"evidence.nothing_drawn", "nothing: no outline is drawn on it", {}};
        return row;
    }
    row.taken = clockTime(found->facts.taken);
    const bool drawn =
        std::any_of(found->masks.begin(), found->masks.end(), [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
    row.says = drawn ? instantOf(found->time) : Message{"evidence.nothing_drawn", "nothing: no outline is drawn on it", {}};
    return row;
}

std::string evidenceFileName(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

EvidenceRow pointsRow(const Site& site) {
    const std::size_t used = usedPoints(site.controlPoints);
    EvidenceRow row{{}, EvidenceForm::Points, {}, {}, {}};
    row.says = {"evidence.points", "where the case lies: {0} of {1} control points are used", {used, site.controlPoints.size()}};
    if (used > 2) {
        const SiteFit fit = fitControlPoints(site.controlPoints);
        row.within = confidence * std::hypot(fit.rmsPlan, fit.rmsHeight);
    }
    return row;
}

}  // namespace

std::span<const std::string_view> endingsOf(EvidenceForm form) {
    switch (form) {
        case EvidenceForm::Heights:
            return heightEndings;
        case EvidenceForm::Cloud:
            return cloudEndings;
        case EvidenceForm::Outline:
            return outlineEndings;
        case EvidenceForm::Photograph:
        case EvidenceForm::Points:
        case EvidenceForm::Measured:
            break;
    }
    return {};
}

bool hasOverlap(const CaseInput& survey) {
    return evidenceFormOf(survey) != EvidenceForm::Measured || survey.held == PointsHeld::Outline;
}

void checkHasOverlap(const CaseInput& survey) {
    checkShowsDebris(survey);
    if (!hasOverlap(survey)) {
        throw UsageError(
            {"survey.held_for_sections", "The points of {0} are held for sections: they have no overlap", {survey.path}},
            {"survey.held_for_sections.remedy", "Hold them as an outline if they are the edge of the debris.", {}});
    }
}

ComparisonSettings photographSettingsOf(const Case& theCase) {
    ComparisonSettings settings;
    settings.withFallen = theCase.evidence.photographsWithFallen;
    return settings;
}

EvidenceForm evidenceFormOf(const CaseInput& survey) {
    if (!survey.kind) {
        return formByEnding(survey.path);
    }
    // [SurveyKind]
    constexpr std::array<EvidenceForm, surveyKindNames.size()> forms{EvidenceForm::Heights, EvidenceForm::Cloud,
                                                                     EvidenceForm::Outline, EvidenceForm::Measured};
    return forms[static_cast<std::size_t>(*survey.kind)];
}

Findings sameEvidence(const Case& theCase, std::string_view which) {
    Findings findings;
    const auto isEvidence = [](const CaseInput& input) {
        return (input.role == InputRole::Survey || input.role == InputRole::Photograph) && !input.sha256.empty();
    };
    for (std::size_t k = 0; k < theCase.inputs.size(); ++k) {
        const CaseInput& later = theCase.inputs[k];
        for (std::size_t i = 0; i < k && isEvidence(later); ++i) {
            const CaseInput& earlier = theCase.inputs[i];
            const bool asked = which.empty() || which == later.id || which == earlier.id;
            if (asked && isEvidence(earlier) && earlier.sha256 == later.sha256) {
                findings.add({"evidence.same",
                              "\"{0}\" and \"{1}\" have the same content: they are one piece of evidence",
                              {evidenceFileName(earlier.path), evidenceFileName(later.path)}},
                             {"evidence.same.remedy", "Take one of them out of the evidence.", {}}, later.path);
                break;
            }
        }
    }
    for (const CaseInput& survey : theCase.inputs) {
        const bool asked = survey.role == InputRole::Survey && !survey.sha256.empty() && (which.empty() || which == survey.id);
        const bool ground = asked && std::any_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) {
                                return input.role == InputRole::Terrain && input.sha256 == survey.sha256;
                            });
        if (ground) {
            findings.add({"evidence.is_terrain",
                          "\"{0}\" is the terrain that the debris of this case falls on: it shows no debris",
                          {evidenceFileName(survey.path)}},
                         {"evidence.is_terrain.remedy", "Take the heights that were measured after the collapse.", {}},
                         survey.path);
        }
    }
    return findings;
}

std::vector<EvidenceRow> evidenceOf(const Case& theCase) {
    std::vector<EvidenceRow> rows;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Photograph) {
            rows.push_back(photographRow(input, theCase.photographs));
        } else if (input.role == InputRole::Survey) {
            rows.push_back(surveyRow(input));
        }
    }
    if (!theCase.site.controlPoints.empty()) {
        rows.push_back(pointsRow(theCase.site));
    }
    return rows;
}

}  // namespace rubble
