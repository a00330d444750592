#include "core/evidence/no_evidence.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rubble {

namespace {

constexpr std::array<std::string_view, 5> noEvidenceIds{"evidence.of_this_run", "evidence.of_run", "evidence.ours", "evidence.same",
                                                        "evidence.is_terrain"};

/// What of a survey, its place, its units or what it shows makes every figure of a comparison doubtful.
constexpr std::array<std::string_view, 21> doubtIds{"terrain.height_unit",
                                                    "terrain.height_unit_unknown",
                                                    "cloud.height_unit_assumed",
                                                    "drawing.unit_unsaid",
                                                    "cloud.perhaps_degrees",
                                                    "survey.no_degrees",
                                                    "cloud.system_unknown",
                                                    "cloud.system_unread",
                                                    "cloud.unplaced",
                                                    "survey.unplaced",
                                                    "survey.far",
                                                    "survey.changed",
                                                    "survey.at_limit",
                                                    "survey.removal_unknown",
                                                    "survey.fallen_unknown",
                                                    "survey.fallen_simulated_only",
                                                    "survey.fallen_surveyed_only",
                                                    "survey.held",
                                                    "survey.standing",
                                                    "survey.offset",
                                                    "survey.beyond"};

Findings thoseOfNoEvidence(const Findings& findings, bool wanted) {
    Findings chosen;
    for (const Finding& finding : findings.list()) {
        const bool says = std::find(noEvidenceIds.begin(), noEvidenceIds.end(), finding.what.id) != noEvidenceIds.end();
        if (says == wanted) {
            chosen.add(finding.what, finding.remedy, finding.example, finding.count);
        }
    }
    return chosen;
}

}  // namespace

Findings noEvidenceOf(const Findings& findings) {
    return thoseOfNoEvidence(findings, true);
}

Findings otherThanNoEvidence(const Findings& findings) {
    return thoseOfNoEvidence(findings, false);
}

Findings noEvidenceFirst(const Findings& findings) {
    Findings all = noEvidenceOf(findings);
    all.append(otherThanNoEvidence(findings));
    return all;
}

std::vector<Caution> evidenceCautions(const Findings& findings) {
    std::vector<Caution> cautions;
    const Findings none = noEvidenceOf(findings);
    for (const Finding& finding : none.list()) {
        cautions.push_back({"no_evidence", HealthGrade::Finding, finding.what});
    }
    for (const Finding& finding : findings.list()) {
        const std::string& id = finding.what.id;
        if (id.starts_with("site.") || std::find(doubtIds.begin(), doubtIds.end(), id) != doubtIds.end()) {
            cautions.push_back({"evidence_doubt", HealthGrade::Finding, finding.what});
        }
    }
    return cautions;
}

}  // namespace rubble
