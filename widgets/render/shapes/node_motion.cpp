#include "widgets/render/shapes/node_motion.h"

namespace rubble::render {

void NodeMotion::Held::moveTo(const FeResult& fe, std::size_t state) {
    const bool first = m_elements.empty();
    if (first) {
        m_elements.assign(fe.mesh().nodeCount(), 0);
    } else if (state == m_state) {
        return;
    }
    for (std::size_t i = 0; i < fe.mesh().elementCount(); ++i) {
        const auto element = idAt<ElementIndex>(i);
        const bool was = !first && fe.activity().active(m_state, element);
        const bool is = fe.activity().active(state, element);
        if (was != is) {
            for (const std::uint32_t node : fe.mesh().cornersOf(element)) {
                m_elements[node] += is ? 1u : ~0u;
            }
        }
    }
    m_state = state;
}

NodeMotion::NodeMotion(std::shared_ptr<const FeResult> fe, std::shared_ptr<StateReadAhead> states)
    : m_fe(std::move(fe)), m_states(std::move(states)) {}

void NodeMotion::moveTo(double time, bool exact) {
    const std::vector<double>& times = m_fe->times();
    // A read that throws must not leave half an interval behind.
    m_interval = exact ? m_states->next(time) : m_states->nearest(time);
    m_exact = exact;
    m_state = m_states->stateAt(time);
    m_share = 0.0f;
    m_between = m_state + 1 < times.size() && time - times[m_state] > sameTime;
    if (m_interval.to == m_interval.from) {
        return;
    }
    m_held.moveTo(*m_fe, m_interval.to);
    const double from = times[m_interval.from];
    m_step = times[m_interval.to] - from;
    m_ratio = m_interval.before < m_interval.from ? m_step / (from - times[m_interval.before]) : 0.0;
    if (time - from > sameTime) {
        m_share = static_cast<float>((time - from) / m_step);
    }
}

Eigen::Vector3f NodeMotion::operator[](std::size_t node) const {
    const Vec3& from = m_interval.atFrom->positions[node];
    if (m_share == 0.0f) {
        return from.cast<float>();
    }
    Vec3 way = Vec3::Zero();
    if (m_held[node]) {
        way = m_interval.atTo->positions[node] - from;
    } else if (!m_interval.atFrom->velocities.empty()) {
        way = m_step * m_interval.atFrom->velocities[node];
    } else if (m_interval.atBefore) {
        way = m_ratio * (from - m_interval.atBefore->positions[node]);
    }
    return from.cast<float>() + m_share * way.cast<float>();
}

}  // namespace rubble::render
