#pragma once

#include <cstdint>
#include <vector>

#include "core/base/archive.h"

namespace rubble {

/// Decides which bodies come to rest: a body whose fastest corner stays below a speed for a while is frozen (treated as infinitely
/// heavy and not integrated). It thaws by a hard hit, or when a body or piece that it touches vanishes or moves away.
class FreezeClock {
public:
    FreezeClock(double speed, double delay) : m_speed(speed), m_delay(delay) {}

    void addBody() { m_bodies.push_back({}); }
    /// It has left.
    void forget(std::size_t body) { m_bodies[body] = {}; }
    /// Takes note of the speed of a body's fastest corner over one step; true when it has been quiet for long enough.
    bool quiet(std::size_t body, double cornerSpeed, double dt);
    /// Starts the wait anew.
    void restart(std::size_t body) { m_bodies[body].quietFor = 0.0; }

    /// Frozen, or quiet for long enough to be.
    bool resting(std::size_t body) const { return m_bodies[body].frozen || m_bodies[body].quietFor >= m_delay; }
    bool frozen(std::size_t body) const { return m_bodies[body].frozen; }
    void freeze(std::size_t body) { m_bodies[body].frozen = true; }
    void thaw(std::size_t body, const Vec3& position);
    /// A frozen body that touches a thawed one: it thaws once that has moved.
    void addDependant(std::size_t thawed, std::uint32_t dependant) { m_bodies[thawed].dependants.push_back(dependant); }
    /// The dependants of a thawed body that has moved by more than the tolerance since; they are forgotten here.
    std::vector<std::uint32_t> takeDependants(std::size_t body, const Vec3& position);
    /// True while a thawed body may still have to thaw others.
    bool watched(std::size_t body) const { return !m_bodies[body].dependants.empty(); }
    std::size_t size() const { return m_bodies.size(); }
    void keep(Archive& archive) { archive(m_bodies); }

private:
    struct Body {
        double quietFor = 0.0;
        bool frozen = false;
        Vec3 thawedAt = Vec3::Zero();
        std::vector<std::uint32_t> dependants;

        void keep(Archive& archive) { archive(quietFor, frozen, thawedAt, dependants); }
    };
    double m_speed;
    double m_delay;
    std::vector<Body> m_bodies;
};

}  // namespace rubble
