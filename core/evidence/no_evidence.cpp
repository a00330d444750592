#include "core/evidence/no_evidence.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rubble {

namespace {

constexpr std::array<std::string_view, 5> noEvidenceIds{"evidence.of_this_run", "evidence.of_run", "evidence.ours", "evidence.same",
                                                        "evidence.is_terrain"};

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
    return cautions;
}

}  // namespace rubble
