#include "core/fragments/birth_windows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace rubble {

namespace {

/// Share of a window by which times may miss its end: files keep them in single precision.
constexpr double timeSlack = 1e-6;
/// Share of a result that a window may take without a word.
constexpr double quietShare = 0.25;
/// Share of a result that a fitting window takes.
constexpr double fittingShare = 0.01;

/// The lifetimes that end with a death, as the activity shows them, ordered by lastActive.
std::vector<Lifetime> endedIn(const Activity& activity) {
    std::vector<Lifetime> ended;
    for (std::size_t e = 0; e < activity.elements(); ++e) {
        const auto element = idAt<ElementIndex>(e);
        bool was = false;
        std::uint32_t since = 0;
        for (std::uint32_t state = 0; state < activity.states(); ++state) {
            const bool is = activity.active(state, element);
            if (is && !was) {
                since = state;
            } else if (was && !is) {
                ended.push_back({element, since, state - 1, state, std::nullopt});
            }
            was = is;
        }
    }
    std::ranges::stable_sort(ended, {}, &Lifetime::lastActive);
    return ended;
}

}  // namespace

BirthWindows::BirthWindows(const std::vector<Lifetime>& ended, const std::vector<double>& times, double window)
    : m_handOver(times.size()) {
    std::iota(m_handOver.begin(), m_handOver.end(), 0u);
    if (!(window > 0.0)) {
        return;
    }
    const double length = window * (1.0 + timeSlack);
    std::optional<std::uint32_t> first;
    for (auto next = ended.begin(); next != ended.end();) {
        const std::uint32_t state = next->lastActive;
        std::uint32_t latestBegin = 0;
        for (; next != ended.end() && next->lastActive == state; ++next) {
            latestBegin = std::max(latestBegin, next->firstActive);
        }
        assert(next == ended.end() || next->lastActive > state);
        if (!first || latestBegin > *first || times[state] - times[*first] > length) {
            first = state;
        }
        m_handOver[state] = *first;
    }
}

bool WindowCover::wide() const {
    return births < instants && window >= quietShare * span;
}

WindowCover coverOf(const std::vector<Lifetime>& ended, const std::vector<double>& times, double window) {
    WindowCover cover;
    cover.window = window;
    cover.span = times.back() - times.front();
    const BirthWindows windows(ended, times, window);
    std::optional<std::uint32_t> before;
    for (const Lifetime& life : ended) {
        if (life.lastActive == before) {
            continue;
        }
        before = life.lastActive;
        const std::uint32_t handOver = windows.handOver(life.lastActive);
        ++cover.instants;
        cover.births += handOver == life.lastActive ? 1 : 0;
        cover.earliest = std::max(cover.earliest, times[life.lastActive] - times[handOver]);
    }
    return cover;
}

double fittingBirthWindow(double span) {
    const double fitting = fittingShare * span;
    if (!(fitting > 0.0) || !std::isfinite(fitting)) {
        return 0.0;
    }
    // Parts of a whole number, so that a decimal fraction is the number that is read for it.
    const int power = static_cast<int>(std::floor(std::log10(fitting)));
    const double unit = std::pow(10.0, std::abs(power));
    return power < 0 ? std::round(fitting * unit) / unit : std::round(fitting / unit) * unit;
}

double birthWindowOf(const FragmentSettings& settings) {
    return settings.birthTime == BirthTime::Exact ? 0.0 : settings.birthWindow;
}

Activity simulatedActivity(const FeResult& fe, const FragmentSettings& settings) {
    Activity activity = activityUnder(fe.activity(), settings.revival);
    const double window = birthWindowOf(settings);
    if (!(window > 0.0)) {
        return activity;
    }
    const std::vector<Lifetime> ended = endedIn(activity);
    const BirthWindows windows(ended, fe.times(), window);
    for (const Lifetime& life : ended) {
        for (std::uint32_t state = windows.handOver(life.lastActive) + 1; state <= life.lastActive; ++state) {
            activity.set(state, life.element, false);
        }
    }
    return activity;
}

}  // namespace rubble
