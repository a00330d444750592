#include "core/fe/loose_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rubble {

namespace {

/// Elements from which on an island counts as large.
constexpr std::size_t largeIsland = 50;

bool onlyGrows(const Activity& activity, std::size_t earlier, std::size_t later) {
    for (std::size_t i = 0; i < activity.elements(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (activity.active(later, e) && !activity.active(earlier, e)) {
            return false;
        }
    }
    return true;
}

/// Calls visit(state, loose islands) from the last state to the first, until it returns false. Nodes are joined backwards through
/// the states, for what has died only comes back on that way.
template <class Visit>
void visitLooseIslands(const FeResult& fe, const Activity& activity, const SiteSurface& ground, Visit visit) {
    if (fe.contents().looseBodies) {
        return;  // a body of a table waits where it is until it is let go
    }
    const Mesh& mesh = fe.mesh();
    const Supports supports(fe, activity, ground);
    NodeGroups groups(mesh.nodeCount());
    std::vector<bool> joined(mesh.elementCount(), false);
    for (std::size_t left = fe.stateCount(); left > 0; --left) {
        const std::size_t k = left - 1;
        if (left < fe.stateCount() && !onlyGrows(activity, k, left)) {
            groups = NodeGroups(mesh.nodeCount());
            joined.assign(mesh.elementCount(), false);
        }
        for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
            if (!joined[i] && activity.active(k, idAt<ElementIndex>(i))) {
                groups.join(mesh.cornersOf(idAt<ElementIndex>(i)));
                joined[i] = true;
            }
        }
        std::vector<LiveIsland> islands = islandsAt(fe, activity, supports, groups, k);
        std::erase_if(islands, [](const LiveIsland& island) { return island.supported; });
        if (!visit(k, std::move(islands))) {
            return;
        }
    }
}

void reportLooking(const FeResult& fe, std::size_t state, const Execution& execution) {
    const double done = static_cast<double>(fe.stateCount() - state) / static_cast<double>(fe.stateCount());
    execution.report({"fe.loose_progress", "looking for loose structure", {}}, done);
}

std::vector<std::vector<LiveIsland>> islandsOfStates(const FeResult& fe, const Activity& activity, const SiteSurface& ground,
                                                     const Execution& execution) {
    std::vector<std::vector<LiveIsland>> islands(fe.stateCount());
    visitLooseIslands(fe, activity, ground, [&](std::size_t k, std::vector<LiveIsland> loose) {
        islands[k] = std::move(loose);
        reportLooking(fe, k, execution);
        return true;
    });
    return islands;
}

/// Follows islands from one state to the next.
class Follower {
public:
    Follower(const FeResult& fe, const Activity& activity, LooseStructure& loose)
        : m_activity(activity), m_loose(loose), m_islandOf(fe.mesh().elementCount(), inNoIsland) {}

    void advance(std::uint32_t state, const std::vector<LiveIsland>& now) {
        std::vector<std::uint32_t> origin;
        for (const LiveIsland& island : now) {
            origin.push_back(originOf(island));
        }
        std::vector<std::uint32_t> index = heirs(now, origin);
        std::vector<LooseStructure::Member> members;
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (index[i] == inNoIsland) {
                index[i] = static_cast<std::uint32_t>(m_loose.islands.size());
                m_loose.islands.push_back({state, state, IslandEnd::Alive, std::nullopt, now[i].elements});
                if (origin[i] != inNoIsland) {
                    m_loose.islands.back().parent = origin[i];
                }
            }
            m_loose.islands[index[i]].to = state;
            for (const ElementIndex e : now[i].elements) {
                members.push_back({e, index[i]});
            }
        }
        std::sort(members.begin(), members.end(), [](const auto& a, const auto& b) { return a.element < b.element; });
        m_loose.members.push_back(std::move(members));
        endThoseGone(state);
        remember(state);
    }

private:
    std::uint32_t before(ElementIndex e) const { return m_islandOf[at(e)]; }

    /// The island of the state before that most of these elements were in.
    std::uint32_t originOf(const LiveIsland& island) const {
        std::map<std::uint32_t, std::size_t> counts;
        std::uint32_t most = inNoIsland;
        for (const ElementIndex e : island.elements) {
            if (before(e) != inNoIsland) {
                ++counts[before(e)];
            }
        }
        for (const auto& [index, count] : counts) {
            if (most == inNoIsland || count > counts[most]) {
                most = index;
            }
        }
        return most;
    }

    /// Which island each one goes on as: what has most elements of an origin is its heir, the first of equals.
    std::vector<std::uint32_t> heirs(const std::vector<LiveIsland>& now, const std::vector<std::uint32_t>& origin) const {
        std::map<std::uint32_t, std::size_t> heirOf;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const auto [heir, first] = heirOf.emplace(origin[i], i);
            if (!first && now[i].elements.size() > now[heir->second].elements.size()) {
                heir->second = i;
            }
        }
        heirOf.erase(inNoIsland);
        std::vector<std::uint32_t> index(now.size(), inNoIsland);
        for (const auto& [island, heir] : heirOf) {
            index[heir] = island;
        }
        return index;
    }

    /// Says of islands of the state before that are none any more how they ended.
    void endThoseGone(std::uint32_t state) {
        if (state == 0) {
            return;
        }
        for (const LooseStructure::Member& member : m_loose.members[state - 1]) {
            LooseIsland& island = m_loose.islands[member.island];
            if (island.to == state || island.end == IslandEnd::Joined) {
                continue;
            }
            if (m_loose.islandOf(state, member.element) != inNoIsland) {
                island.end = IslandEnd::Joined;
            } else if (m_activity.active(state, member.element)) {
                island.end = IslandEnd::Supported;
            } else if (island.end == IslandEnd::Alive) {
                island.end = IslandEnd::Died;
            }
        }
    }

    void remember(std::uint32_t state) {
        if (state > 0) {
            for (const LooseStructure::Member& member : m_loose.members[state - 1]) {
                m_islandOf[at(member.element)] = inNoIsland;
            }
        }
        for (const LooseStructure::Member& member : m_loose.members[state]) {
            m_islandOf[at(member.element)] = member.island;
        }
    }

    const Activity& m_activity;
    LooseStructure& m_loose;
    std::vector<std::uint32_t> m_islandOf;  ///< [elements] at the state before
};

/// The value below which a share of the sorted values lies, by rank.
double quantile(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))];
}

/// First state since which an element that is loose at a state has been loose, in one island or another.
std::size_t looseSince(const LooseStructure& loose, std::size_t state, ElementIndex element) {
    while (state > 0 && loose.islandOf(state - 1, element) != inNoIsland) {
        --state;
    }
    return state;
}

void countAtOnce(const LooseStructure& loose, LooseAccount& account) {
    std::int64_t statesWithLoose = 0;
    std::int64_t large = 0;
    for (const std::vector<LooseStructure::Member>& members : loose.members) {
        std::map<std::uint32_t, std::size_t> sizes;
        for (const LooseStructure::Member& member : members) {
            ++sizes[member.island];
        }
        const std::int64_t here = std::count_if(sizes.begin(), sizes.end(), [](const auto& s) { return s.second >= largeIsland; });
        statesWithLoose += !members.empty();
        large += here;
        account.largeAtOnce = std::max(account.largeAtOnce, here);
        account.looseAtOnce = std::max(account.looseAtOnce, static_cast<std::int64_t>(members.size()));
    }
    if (statesWithLoose > 0) {
        account.largeMean = static_cast<double>(large) / static_cast<double>(statesWithLoose);
    }
}

/// What died in each island and when: s since it came loose; and over all, s since each element did.
struct LooseDeaths {
    std::vector<std::vector<double>> ofIsland;  ///< [islands]
    std::vector<double> all;
    std::int64_t dead = 0;
};

LooseDeaths deathsIn(const LooseStructure& loose, const std::vector<double>& times, const Activity& activity) {
    LooseDeaths deaths;
    deaths.ofIsland.resize(loose.islands.size());
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
        for (std::size_t i = 0; i < activity.elements(); ++i) {
            const ElementIndex e = idAt<ElementIndex>(i);
            if (!activity.active(k, e) || activity.active(k + 1, e)) {
                continue;
            }
            ++deaths.dead;
            const std::uint32_t island = loose.islandOf(k, e);
            if (island != inNoIsland) {
                deaths.all.push_back(times[k] - times[looseSince(loose, k, e)]);
                deaths.ofIsland[island].push_back(times[k] - times[loose.islands[island].from]);
            }
        }
    }
    std::sort(deaths.all.begin(), deaths.all.end());
    return deaths;
}

}  // namespace

std::uint32_t LooseStructure::islandOf(std::size_t state, ElementIndex element) const {
    const std::vector<Member>& list = members[state];
    const auto found =
        std::lower_bound(list.begin(), list.end(), element, [](const Member& m, ElementIndex e) { return m.element < e; });
    if (found == list.end() || found->element != element) {
        return inNoIsland;
    }
    return found->island;
}

bool comesLoose(const FeResult& fe, const Activity& activity, const SiteSurface& ground) {
    bool found = false;
    visitLooseIslands(fe, activity, ground, [&](std::size_t k, const std::vector<LiveIsland>& loose) {
        found = k + 1 < fe.stateCount() && std::ranges::any_of(loose, [&](const LiveIsland& island) {
                    return std::ranges::any_of(island.elements, [&](ElementIndex e) { return activity.active(k + 1, e); });
                });
        return !found;
    });
    return found;
}

LooseAtOnce mostLooseAtOnce(const FeResult& fe, const Activity& activity, const SiteSurface& ground, const Execution& execution) {
    LooseAtOnce most;
    visitLooseIslands(fe, activity, ground, [&](std::size_t k, const std::vector<LiveIsland>& loose) {
        LooseAtOnce here{fe.times()[k], 0, 0};
        for (const LiveIsland& island : loose) {
            const auto living =
                k + 1 < fe.stateCount()
                    ? std::ranges::count_if(island.elements, [&](ElementIndex e) { return activity.active(k + 1, e); })
                    : 0;
            here.islands += living > 0;
            here.elements += living;
        }
        most = here.elements > most.elements ? here : most;
        reportLooking(fe, k, execution);
        return true;
    });
    return most;
}

LooseStructure looseStructure(const FeResult& fe, const Activity& activity, const SiteSurface& ground, const Execution& execution) {
    const std::vector<std::vector<LiveIsland>> islands = islandsOfStates(fe, activity, ground, execution);
    LooseStructure loose;
    Follower follower(fe, activity, loose);
    for (std::size_t k = 0; k < islands.size(); ++k) {
        follower.advance(static_cast<std::uint32_t>(k), islands[k]);
    }
    return loose;
}

LooseAccount accountOf(const LooseStructure& loose, const FeResult& fe, const Activity& activity, const Components& components) {
    LooseAccount account;
    LooseDeaths deaths = deathsIn(loose, fe.times(), activity);
    account.dead = deaths.dead;
    account.deadLoose = static_cast<std::int64_t>(deaths.all.size());
    account.tenth = quantile(deaths.all, 0.1);
    account.median = quantile(deaths.all, 0.5);
    account.ninetieth = quantile(deaths.all, 0.9);
    for (std::size_t i = 0; i < loose.islands.size(); ++i) {
        const LooseIsland& island = loose.islands[i];
        IslandFate fate;
        fate.island = static_cast<std::uint32_t>(i);
        fate.from = fe.times()[island.from];
        fate.to = fe.times()[island.to];
        fate.elements = static_cast<std::int64_t>(island.elements.size());
        for (const ElementIndex e : island.elements) {
            const double mass = components.mass(e);
            fate.mass += std::isfinite(mass) ? mass : 0.0;
        }
        std::vector<double>& seconds = deaths.ofIsland[i];
        std::sort(seconds.begin(), seconds.end());
        fate.died = static_cast<std::int64_t>(seconds.size());
        fate.medianSeconds = quantile(seconds, 0.5);
        account.islands.push_back(fate);
    }
    std::stable_sort(account.islands.begin(), account.islands.end(), [](const auto& a, const auto& b) { return a.mass > b.mass; });
    countAtOnce(loose, account);
    return account;
}

}  // namespace rubble
