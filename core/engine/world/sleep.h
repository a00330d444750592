#pragma once

#include <cstdint>
#include <vector>

#include "core/engine/world/collider.h"
#include "core/engine/world/freeze.h"

namespace rubble {

/// Which bodies are frozen, and whom one that thaws has to wake. Whether two colliders touch the engine knows: where it matters it
/// hands over a function that calls visit(a, b) for every touching pair.
class Sleep {
public:
    Sleep(double speed, double delay) : m_clock(speed, delay) {}

    /// The next body, awake.
    void addBody();
    /// Its body has left.
    void forget(const Collider& body);
    FreezeClock& clock() { return m_clock; }
    const FreezeClock& clock() const { return m_clock; }

    bool awake(const Collider& c) const { return c.kind == ColliderKind::Body && m_still[c.index] == 0; }
    /// A body, and not awake.
    bool frozen(const Collider& c) const { return c.kind == ColliderKind::Body && m_still[c.index] != 0; }
    /// It is there and not awake.
    bool frozen(std::uint32_t body) const { return m_clock.frozen(body); }
    /// It may touch in this step what it did not touch before: awake, or a piece that moves, or new.
    bool stirs(const Collider& c) const { return awake(c) || c.moving || c.newborn; }
    /// [bodies] frozen or gone
    const std::vector<char>& still() const { return m_still; }

    void freeze(const Collider& body);
    /// @param position  m, where it is: once it has moved from there it wakes what it touched, see linkDependants()
    void thaw(Collider& body, const Vec3& position);
    /// Whether `other` wakes a frozen body that it comes near to: a piece or a newborn that touches it, or a hard hit.
    /// @param approach  m/s, of `other` towards the body
    bool wakes(const Collider& other, double approach, bool touches) const;

    /// Notes who is to wake once those that thawed have moved: the frozen bodies that touch them.
    template <class ForEachTouching>
    void linkDependants(ForEachTouching forEachTouching) {
        if (m_justThawed.empty()) {
            return;
        }
        forEachTouching([this](const Collider& a, const Collider& b) { link(a, b); });
        forgetThawed();
    }
    /// Frozen bodies that touch what is marked as leaving, in the order of their numbers.
    template <class ForEachTouching>
    std::vector<Collider*> neighboursOfLeaving(ForEachTouching forEachTouching) const {
        std::vector<Collider*> sleepers;
        forEachTouching([&](Collider& a, Collider& b) {
            if (Collider& left = a.leaving ? b : a; a.leaving != b.leaving && frozen(left)) {
                sleepers.push_back(&left);
            }
        });
        sortOut(sleepers);
        return sleepers;
    }
    /// Frozen bodies that a thawed one wakes now that it is at `position` [m].
    std::vector<std::uint32_t> wokenBy(const Collider& body, const Vec3& position);
    /// Thawed and not linked yet.
    const std::vector<Collider*>& justThawed() const { return m_justThawed; }

    /// @param bodies  that ever entered, in order
    template <class Bodies>
    void keep(Archive& archive, const Bodies& bodies) {
        std::vector<std::uint32_t> thawed = thawedIndices();
        archive(m_clock, m_still, thawed);
        if (m_still.size() != bodies.size() || m_clock.size() != bodies.size()) {
            Archive::fail();
        }
        m_justThawed.clear();
        for (const std::uint32_t i : thawed) {
            if (i >= bodies.size()) {
                Archive::fail();
            }
            m_justThawed.push_back(bodies[i].get());
        }
    }

private:
    void link(const Collider& a, const Collider& b);
    void forgetThawed();
    std::vector<std::uint32_t> thawedIndices() const;
    static void sortOut(std::vector<Collider*>& sleepers);

    FreezeClock m_clock;
    std::vector<char> m_still;  ///< [bodies] frozen or gone
    std::vector<Collider*> m_justThawed;
};

}  // namespace rubble
