#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/unknown.h"
#include "core/scenario/case.h"

namespace rubble {

/// What evidence is; a survey of a case of before, where that was not kept, by the ending of its file.
enum class EvidenceForm { Photograph, Heights, Cloud, Outline, Points };
/// "photograph", "heights", "cloud", "outline", "points"
inline constexpr std::array<const char*, 5> evidenceFormNames{"photograph", "heights", "cloud", "outline", "points"};

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
};

/// All evidence of a case in one list: photographs, surveys, control points, in the order of the case. Scores are left open, and so
/// are the place of a photograph, which its camera tells, and what lies elsewhere.
std::vector<EvidenceRow> evidenceOf(const Case& theCase);

}  // namespace rubble
