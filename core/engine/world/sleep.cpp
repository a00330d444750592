#include "core/engine/world/sleep.h"

#include <algorithm>
#include <iterator>

#include "core/engine/world/constants.h"

namespace rubble {

void Sleep::addBody() {
    m_clock.addBody();
    m_still.push_back(0);
}

void Sleep::forget(const Collider& body) {
    m_clock.forget(body.index);
    m_still[body.index] = 1;
}

void Sleep::freeze(const Collider& body) {
    m_clock.freeze(body.index);
    m_still[body.index] = 1;
}

void Sleep::thaw(Collider& body, const Vec3& position) {
    m_clock.thaw(body.index, position);
    m_still[body.index] = 0;
    body.justThawed = true;
    m_justThawed.push_back(&body);
}

bool Sleep::wakes(const Collider& other, double approach, bool touches) const {
    const bool carriesOff = other.kind == ColliderKind::Piece && (other.moving || other.newborn) && touches;
    return carriesOff || (awake(other) && approach > thawSpeed);
}

void Sleep::link(const Collider& a, const Collider& b) {
    const Collider& thawed = a.justThawed ? a : b;
    const Collider& other = a.justThawed ? b : a;
    if (a.justThawed != b.justThawed && other.kind == ColliderKind::Body && m_clock.frozen(other.index)) {
        m_clock.addDependant(thawed.index, other.index);
    }
}

void Sleep::forgetThawed() {
    for (Collider* body : m_justThawed) {
        body->justThawed = false;
    }
    m_justThawed.clear();
}

std::vector<std::uint32_t> Sleep::wokenBy(const Collider& body, const Vec3& position) {
    std::vector<std::uint32_t> woken = m_clock.takeDependants(body.index, position);
    std::ranges::sort(woken);
    woken.erase(std::unique(woken.begin(), woken.end()), woken.end());
    std::erase_if(woken, [&](std::uint32_t i) { return !m_clock.frozen(i); });
    return woken;
}

std::vector<std::uint32_t> Sleep::thawedIndices() const {
    std::vector<std::uint32_t> indices;
    std::ranges::transform(m_justThawed, std::back_inserter(indices), [](const Collider* body) { return body->index; });
    return indices;
}

void Sleep::sortOut(std::vector<Collider*>& sleepers) {
    std::ranges::sort(sleepers, {}, &Collider::number);
    sleepers.erase(std::unique(sleepers.begin(), sleepers.end()), sleepers.end());
}

}  // namespace rubble
