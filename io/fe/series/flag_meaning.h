#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"

namespace rubble::io {

/// What one value of an active flag means. Unusual values are counted.
class FlagMeaning {
public:
    FlagMeaning(double activeValue, Findings& findings) : m_activeValue(activeValue), m_findings(findings) {}

    /// @param before   whether the element was active at the state before; holds where the value is no number
    /// @param element  the user's element number, for the finding
    bool active(double value, bool before, std::int64_t element, std::size_t state);

private:
    void note(const char* id, const char* text, std::int64_t element, std::size_t state, double value);

    const double m_activeValue;
    Findings& m_findings;
};

/// The value that most elements hold, rounded; 1 where there is none. Decides polarity where the name does not.
double mostCommonFlag(const std::vector<double>& flags);

}  // namespace rubble::io
