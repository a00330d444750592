#include "widgets/render/node_motion.h"

#include <algorithm>
#include <limits>

namespace rubble::render {
namespace {

constexpr double sameTime = 1e-6;  // s; a view's time that went through text still hits its state
constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();

/// Which nodes an active element holds at a state.
std::vector<std::uint8_t> heldNodes(const FeResult& fe, std::size_t state) {
    std::vector<std::uint8_t> held(fe.mesh().nodeCount(), 0);
    for (std::size_t i = 0; i < fe.mesh().elementCount(); ++i) {
        if (fe.activity().active(state, idAt<ElementIndex>(i))) {
            for (const std::uint32_t node : fe.mesh().cornersOf(idAt<ElementIndex>(i))) {
                held[node] = 1;
            }
        }
    }
    return held;
}

}  // namespace

NodeMotion::NodeMotion(std::shared_ptr<const FeResult> fe) : m_fe(std::move(fe)), m_loaded(nothing) {}

void NodeMotion::moveTo(double time) {
    const std::vector<double>& times = m_fe->times();
    const auto after = std::upper_bound(times.begin(), times.end(), time + sameTime);
    m_state = after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
    if (m_loaded != m_state) {
        load(m_state);
    }
    m_share = 0.0f;
    if (after != times.begin() && after != times.end() && time - times[m_state] > sameTime) {
        m_share = static_cast<float>((time - times[m_state]) / (times[m_state + 1] - times[m_state]));
    }
}

void NodeMotion::load(std::size_t k) {
    m_loaded = nothing;  // a read that throws must not leave a half-filled interval behind
    const auto now = m_fe->state(k);
    const std::size_t nodes = m_fe->mesh().nodeCount();
    m_base.resize(nodes);
    m_delta.assign(nodes, Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < nodes; ++i) {
        m_base[i] = now->positions[i].cast<float>();
    }
    if (k + 1 < m_fe->stateCount()) {
        const auto next = m_fe->state(k + 1);
        const double step = m_fe->times()[k + 1] - m_fe->times()[k];
        const auto held = heldNodes(*m_fe, k + 1);
        const bool velocities = now->velocities.size() == nodes;
        const auto before = !velocities && k > 0 ? m_fe->state(k - 1) : nullptr;
        const double ratio = before ? step / (m_fe->times()[k] - m_fe->times()[k - 1]) : 0.0;
        for (std::size_t i = 0; i < nodes; ++i) {
            Vec3 delta = Vec3::Zero();
            if (held[i]) {
                delta = next->positions[i] - now->positions[i];
            } else if (velocities) {
                delta = step * now->velocities[i];
            } else if (before) {
                delta = ratio * (now->positions[i] - before->positions[i]);
            }
            m_delta[i] = delta.cast<float>();
        }
    }
    m_loaded = k;
}

}  // namespace rubble::render
