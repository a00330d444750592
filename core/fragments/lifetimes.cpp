#include "core/fragments/lifetimes.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/fragments/element_place.h"

namespace rubble {

namespace {

enum class Phase : std::uint8_t {
    NotYet,  ///< not active at any state so far
    Active,
    Dead,
    DeadForGood,  ///< under Latch
    Ignored       ///< under Latch: came back, was counted
};

/// What is known of one element while the states go by.
struct Life {
    Phase phase = Phase::NotYet;
    std::uint32_t since = 0;  ///< first state of the current run of active states
    std::size_t ended = 0;    ///< index of its last ended lifetime, once there is one
};

class LifetimeScan {
public:
    LifetimeScan(const FeResult& fe, const Components& components, Revival policy, Findings& findings)
        : m_fe(fe), m_components(components), m_policy(policy), m_findings(findings), m_lives(fe.mesh().elementCount()) {}

    void visit(std::uint32_t state) {
        const Activity& activity = m_fe.activity();
        for (std::size_t e = 0; e < m_lives.size(); ++e) {
            const bool active = activity.active(state, idAt<ElementIndex>(e));
            Life& life = m_lives[e];
            if (life.phase == Phase::Active) {
                if (!active) {
                    die(e, state);
                }
            } else if (active && life.phase == Phase::DeadForGood) {
                countRevived(e, state);
                life.phase = Phase::Ignored;
            } else if (active && life.phase != Phase::Ignored) {
                appear(e, state);
            }
        }
    }

    std::vector<Lifetime> finish() {
        for (std::size_t e = 0; e < m_lives.size(); ++e) {
            if (m_lives[e].phase == Phase::NotYet) {
                m_findings.add({"fragments.never_active", "An element is inactive at every state and makes no fragment", {}},
                               {"fragments.never_active.remedy",
                                "If it should be debris, check the name and the polarity of the active flag.",
                                {}},
                               place(e, 0));
            }
        }
        // By the user's number, so that the order of the elements in the file reaches no result.
        const std::vector<std::int64_t>& number = m_fe.mesh().elementIds;
        std::ranges::sort(m_ended, {},
                          [&](const Lifetime& l) { return std::tuple(l.lastActive, number[at(l.element)], at(l.element)); });
        return std::move(m_ended);
    }

private:
    std::string place(std::size_t e, std::size_t state) const {
        return elementPlace(m_fe.mesh(), m_components, idAt<ElementIndex>(e), state);
    }

    void countRevived(std::size_t e, std::uint32_t state) {
        m_findings.add({"fragments.revived", "An element comes back to life after its death", {}},
                       {"fragments.revived.remedy",
                        m_policy == Revival::Latch ? "It stays dead (revival = latch); revival = follow lets it come back."
                                                   : "Its fragment ends then (revival = follow); revival = latch keeps it dead.",
                        {}},
                       place(e, state));
    }

    void appear(std::size_t e, std::uint32_t state) {
        Life& life = m_lives[e];
        if (life.phase == Phase::Dead) {
            if (m_policy == Revival::Refuse) {
                throw UsageError(
                    {"fragments.revival_refused",
                     "{0}: {1} comes back to life, which revival = refuse forbids",
                     {m_fe.contents().path, place(e, state)}},
                    {"fragments.revival_refused.remedy", "Set revival to latch (dead is dead) or follow (its fragment ends).", {}});
            }
            countRevived(e, state);
            m_ended[life.ended].backAt = state;
        } else if (state > 0) {
            m_findings.add({"fragments.activated_later", "An element is inactive at first and appears later", {}},
                           {"fragments.activated_later.remedy",
                            "It counts as structure from then on; check the polarity of the active flag if this is not meant.",
                            {}},
                           place(e, state));
        }
        life.phase = Phase::Active;
        life.since = state;
    }

    void die(std::size_t e, std::uint32_t state) {
        Life& life = m_lives[e];
        life.ended = m_ended.size();
        life.phase = m_policy == Revival::Latch ? Phase::DeadForGood : Phase::Dead;
        m_ended.push_back({idAt<ElementIndex>(e), life.since, state - 1, state, std::nullopt});
    }

    const FeResult& m_fe;
    const Components& m_components;
    Revival m_policy;
    Findings& m_findings;
    std::vector<Life> m_lives;
    std::vector<Lifetime> m_ended;
};

}  // namespace

std::vector<Lifetime> endedLifetimes(const FeResult& fe, const Components& components, Revival policy, Findings& findings,
                                     const Execution& execution) {
    LifetimeScan scan(fe, components, policy, findings);
    for (std::uint32_t state = 0; state < fe.stateCount(); ++state) {
        execution.check();
        scan.visit(state);
    }
    return scan.finish();
}

Activity activityUnder(const Activity& file, Revival policy) {
    if (policy != Revival::Latch) {
        return file;
    }
    Activity latched(file.states(), file.elements());
    for (std::size_t e = 0; e < file.elements(); ++e) {
        const auto element = idAt<ElementIndex>(e);
        std::size_t state = 0;
        while (state < file.states() && !file.active(state, element)) {
            ++state;
        }
        for (; state < file.states() && file.active(state, element); ++state) {
            latched.set(state, element, true);
        }
    }
    return latched;
}

}  // namespace rubble
