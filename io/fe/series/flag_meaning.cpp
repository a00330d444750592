#include "io/fe/series/flag_meaning.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble::io {

namespace {

constexpr double rounding = 1e-6;

}  // namespace

bool FlagMeaning::active(double value, bool before, std::int64_t element, std::size_t state) {
    if (std::isnan(value)) {
        note("fe.flag_nan", "The active flag is not a number; the element stays as it was at the state before", element, state,
             value);
        return before;
    }
    if (m_activeValue != 0.0 && m_activeValue != 1.0) {
        return std::abs(value - m_activeValue) <= rounding;
    }
    const bool whole = std::abs(value) <= rounding || std::abs(value - 1.0) <= rounding;
    if (!whole && value > 0.0 && value < 1.0) {
        note("fe.flag_fading", "The active flag lies between active and dead; the element counts as active until it is dead",
             element, state, value);
        return true;
    }
    if (!whole) {
        note("fe.flag_other", "The active flag is neither 0 nor 1", element, state, value);
    }
    // Dead is 0, whatever else stands for rigid or special; where active is 0, everything else is dead.
    return m_activeValue == 1.0 ? std::abs(value) > rounding : std::abs(value) <= rounding;
}

void FlagMeaning::note(const char* id, const char* text, std::int64_t element, std::size_t state, double value) {
    // Asked for before a text is made: a fading flag can be met millions of times.
    if (m_findings.count(id) > 0) {
        m_findings.add({id, text, {}}, {}, {});
        return;
    }
    m_findings.add({id, text, {}},
                   {"fe.flag.remedy", "Check the variable: --set status_variable=NAME and active_value say another.", {}},
                   "element " + englishInteger(element) + " at state " + englishInteger(static_cast<std::int64_t>(state)) + ": " +
                       englishNumber(value));
}

double mostCommonFlag(const std::vector<double>& flags) {
    std::map<double, std::size_t> votes;
    for (const double flag : flags) {
        if (std::isfinite(flag)) {
            ++votes[std::round(flag)];
        }
    }
    const auto most =
        std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == votes.end() ? 1.0 : most->first;
}

}  // namespace rubble::io
