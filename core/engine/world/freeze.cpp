#include "core/engine/world/freeze.h"

#include <utility>

#include "core/engine/world/constants.h"

namespace rubble {

bool FreezeClock::quiet(std::size_t body, double cornerSpeed, double dt) {
    Body& clock = m_bodies[body];
    clock.quietFor = cornerSpeed < m_speed ? clock.quietFor + dt : 0.0;
    return clock.quietFor >= m_delay;
}

void FreezeClock::thaw(std::size_t body, const Vec3& position) {
    m_bodies[body] = {0.0, false, position, {}};
}

std::vector<std::uint32_t> FreezeClock::takeDependants(std::size_t body, const Vec3& position) {
    Body& clock = m_bodies[body];
    if ((position - clock.thawedAt).squaredNorm() < thawTravel * thawTravel) {
        return {};
    }
    return std::exchange(clock.dependants, {});
}

}  // namespace rubble
