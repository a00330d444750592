#pragma once

#include "core/base/outline.h"

namespace rubble {

/// What a polygon says of a survey.
enum class ScopePart { Area, LeftOut };

/// What of a survey belongs to the comparison, in the local frame: what lies within the area of interest, if there is one, and not
/// within what is left out.
struct SurveyScope {
    Outline area;
    Outline leftOut;

    Outline& part(ScopePart which) { return which == ScopePart::Area ? area : leftOut; }
    const Outline& part(ScopePart which) const { return which == ScopePart::Area ? area : leftOut; }
    /// Everything belongs to it.
    bool whole() const { return area.empty() && leftOut.empty(); }
    friend bool operator==(const SurveyScope&, const SurveyScope&) = default;
};

}  // namespace rubble
