#pragma once

#include <vector>

#include "core/base/finding.h"
#include "core/evidence/cautions.h"

namespace rubble {

/// What says that a piece of evidence is none: it was made from a run, or counts twice.
Findings noEvidenceOf(const Findings& findings);
/// All but that.
Findings otherThanNoEvidence(const Findings& findings);
/// All, with that in front.
Findings noEvidenceFirst(const Findings& findings);

/// The same as cautions ("no_evidence"), then what makes the figures of a comparison doubtful ("evidence_doubt"): an assumed unit
/// or system of the survey, a place that does not fit, what one side holds and the other does not.
std::vector<Caution> evidenceCautions(const Findings& findings);

}  // namespace rubble
