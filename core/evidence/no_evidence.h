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

/// The same as cautions, for what is made of a comparison.
std::vector<Caution> evidenceCautions(const Findings& findings);

}  // namespace rubble
