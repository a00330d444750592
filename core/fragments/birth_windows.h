#pragma once

#include <cstdint>
#include <vector>

#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "core/fragments/lifetimes.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// States whose deaths are handed over together: at the first of them, where all that dies in the window is still active. The next
/// window begins at the first hand-over that lies outside, or at one of an element that became active in the middle. A window that
/// is 0 s long leaves every state by itself.
class BirthWindows {
public:
    /// @param ended   ordered by lastActive, as the file has them
    /// @param times   s, of the FE states, ascending
    /// @param window  s, from the first hand-over of a window to its last
    BirthWindows(const std::vector<Lifetime>& ended, const std::vector<double>& times, double window);

    /// The state at which what was last active at that one is handed over: that one or an earlier one.
    std::uint32_t handOver(std::uint32_t lastActive) const { return m_handOver[lastActive]; }

private:
    std::vector<std::uint32_t> m_handOver;  // [states]
};

/// What a birth window does to the deaths of a result.
struct WindowCover {
    double window = 0.0;       ///< s
    double span = 0.0;         ///< s, from the first state of the result to the last
    std::size_t instants = 0;  ///< of hand-over, each state by itself
    std::size_t births = 0;    ///< instants of hand-over with the window
    double earliest = 0.0;     ///< s, by which something is handed over before its own state, at most

    /// Deaths of several states are joined over a quarter of the result or more: what the window was meant to round off is much of
    /// what there was.
    bool wide() const;
};
/// @param ended, times, window  as BirthWindows has them
WindowCover coverOf(const std::vector<Lifetime>& ended, const std::vector<double>& times, double window);

/// s, for a result that lasts so many seconds: a hundredth of them, as the default is of ten seconds, to one digit.
double fittingBirthWindow(double span);

/// s, of the windows that these settings ask for: none with exact birth times, which part what a window takes together.
double birthWindowOf(const FragmentSettings& settings);

/// Activity as the simulation takes it: under the policy (activityUnder()), and with a birth window an element is inactive from the
/// state after its hand-over on.
Activity simulatedActivity(const FeResult& fe, const FragmentSettings& settings);

}  // namespace rubble
