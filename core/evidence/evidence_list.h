#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/base/unknown.h"
#include "core/evidence/photographs/photo_comparison.h"
#include "core/scenario/case.h"

namespace rubble {

/// What evidence is; a survey of a case of before, where that was not kept, by the ending of its file.
/// Points are the control points of the case, measured ones those of a total station or a drawing.
enum class EvidenceForm { Photograph, Heights, Cloud, Outline, Points, Measured };
/// "photograph", "heights", "cloud", "outline", "points", "measured"
inline constexpr std::array<const char*, 6> evidenceFormNames{"photograph", "heights", "cloud", "outline", "points", "measured"};

/// A thing that a case is held against, and what it is held to say.
struct EvidenceRow {
    std::string id;  ///< of the input; empty of the control points
    EvidenceForm form = EvidenceForm::Heights;
    std::string path;         ///< as the case has it; empty of the control points
    std::string taken;        ///< date and time; empty: not known
    Message says;             ///< which debris it shows, at which instant
    double within = unknown;  ///< m, its place is known to, at 95 %; NaN: not known
    double score = unknown;   ///< overlap with the simulated debris, 0 to 1; NaN: none was made
    Message elsewhere = {};   ///< what says that it lies elsewhere than its site; without id: nothing does
    Message unread = {};      ///< why it cannot be read, or is no evidence; without id: it can, or nobody has looked yet
    bool byEnding = false;    ///< what it is was told by the ending of its file; nobody has looked into it
    std::optional<PointsHeld> held = std::nullopt;  ///< of measured points
    std::string run = {};                           ///< fingerprint of the run that the file was made from, hex; empty: none
    bool ours = false;                              ///< this program wrote the file
};

/// Endings of files that heights, clouds or outlines are read from, in small letters: ".las". Of other evidence none.
std::span<const std::string_view> endingsOf(EvidenceForm form);

/// A survey that can be held against the debris by overlap, and not in sections alone.
bool hasOverlap(const CaseInput& survey);
/// Throws UsageError as checkShowsDebris(), and for measured points that sections are held against.
void checkHasOverlap(const CaseInput& survey);
/// What photographs of a case are compared with, where nothing else is asked for.
ComparisonSettings photographSettingsOf(const Case& theCase);

/// What a survey is, by what was found in its file, else by its ending.
EvidenceForm evidenceFormOf(const CaseInput& survey);

/// That files of a case are one and the same by their SHA-256, one finding each time: they are one piece of evidence.
/// @param which  id of an input: what is said of it alone; empty: of all
Findings sameEvidence(const Case& theCase, std::string_view which = {});

/// All evidence of a case in one list: photographs, surveys, control points, in the order of the case. Scores are left open, and so
/// are the place of a photograph, which its camera tells, and what lies elsewhere.
std::vector<EvidenceRow> evidenceOf(const Case& theCase);

}  // namespace rubble
