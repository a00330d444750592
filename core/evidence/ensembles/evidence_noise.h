#pragma once

#include <cstdint>
#include <span>

#include "core/base/finding.h"
#include "core/evidence/ensembles/cause_comparison.h"

namespace rubble {

/// Evidence whose surveyed heights count from their level of detection on, by the rule of a survey: of noise that is stated, else
/// of that of the cells that lie far from all debris of all members. What is lower may be noise, on either side. Level of
/// detection, noise that is not known, and an offset of the survey are findings.
CauseEvidence withDetection(const CauseEvidence& evidence, std::span<const Hypothesis> hypotheses, Findings& findings);

/// A surface as that evidence would have shown it: where this was surveyed with noise, with as much, drawn anew. It is the same
/// over squares of 2 pi L^2, L being the length over which the noise hangs together.
/// @param cell  m
SurfaceEvidence surveyedAs(const MemberSurface& surface, const SurfaceEvidence& like, double cell, std::uint64_t seed);

/// Says how much of what was seen lies apart from all debris of all members, if that is much: it may be no debris at all.
void findApart(Findings& findings, const SurfaceEvidence& evidence, std::span<const Hypothesis> hypotheses);

}  // namespace rubble
