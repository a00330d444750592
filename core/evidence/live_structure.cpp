#include "core/evidence/live_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/fragments/element_solid.h"
#include "core/fragments/lifetimes.h"

namespace rubble {

namespace {

/// Places of the nodes at one instant.
class NodePlaces {
public:
    NodePlaces(const FeResult& fe, const Activity& activity, double time) : m_activity(activity) {
        const std::vector<double>& times = fe.times();
        const auto after = std::upper_bound(times.begin(), times.end(), time);
        m_state = after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
        m_now = fe.state(m_state);
        if (after != times.begin() && after != times.end() && time > times[m_state]) {
            m_next = fe.state(m_state + 1);
            m_share = (time - times[m_state]) / (*after - times[m_state]);
        }
    }

    std::size_t state() const { return m_state; }
    bool alive(ElementIndex e) const { return m_activity.active(m_state, e); }
    Vec3 place(ElementIndex e, std::uint32_t node) const {
        const Vec3& now = m_now->positions[node];
        // What dies on the way has no place after.
        return m_next && m_activity.active(m_state + 1, e) ? Vec3(now + m_share * (m_next->positions[node] - now)) : now;
    }

private:
    const Activity& m_activity;
    std::size_t m_state = 0;
    double m_share = 0.0;
    std::shared_ptr<const FeState> m_now;
    std::shared_ptr<const FeState> m_next;
};

/// Where the released islands have been carried since the last FE state.
std::vector<std::optional<Pose>> carriedSince(const FeResult& fe, const TrajectoryReader& trajectory, double time) {
    std::vector<std::optional<Pose>> carried(fe.mesh().elementCount());
    if (!(time > fe.times().back())) {
        return carried;
    }
    const std::vector<BodyRecord> bodies = trajectory.bodies();
    const TrajectoryFrame frame = frameAtTime(trajectory, time);
    for (const IslandRecord& island : trajectory.islands()) {
        const std::size_t b = at(island.body);
        if (b >= frame.bodies() || b >= bodies.size()) {
            continue;
        }
        const Quat turn = frame.orientations[b].cast<double>().normalized() * bodies[b].atBirth.orientation.conjugate();
        const Pose pose{frame.positions[b].cast<double>() - turn * bodies[b].atBirth.position, turn};
        for (const ElementIndex e : island.elements) {
            if (at(e) < carried.size()) {
                carried[at(e)] = pose;
            }
        }
    }
    return carried;
}

}  // namespace

LiveStructure displacedStructure(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                                 const FragmentSet& fragments, const Debris& debris, const TrajectoryReader& trajectory,
                                 double threshold, const Execution& execution) {
    const Mesh& mesh = fe.mesh();
    const Activity activity = activityUnder(fe.contents().activity, settings.revival);
    const NodePlaces nodes(fe, activity, debris.time);
    const std::vector<std::optional<Pose>> carried = carriedSince(fe, trajectory, debris.time);
    std::vector<bool> isFragment(mesh.elementCount(), false);
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        isFragment[at(fragments.list[f].element)] = isFragment[at(fragments.list[f].element)] || debris.fragments[f].present;
    }
    LiveStructure live;
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        if (i % 4096 == 0) {
            execution.check();
        }
        const ElementIndex e = idAt<ElementIndex>(i);
        const double mass = components.mass(e);
        if (isFragment[i] || !nodes.alive(e) || !(mass > 0.0) || !std::isfinite(mass)) {
            continue;
        }
        CornerMotion motion;
        Vec3 moved = Vec3::Zero();
        for (const std::uint32_t node : mesh.cornersOf(e)) {
            Vec3 place = nodes.place(e, node);
            if (carried[i]) {
                place = *carried[i] * place;
            }
            motion.positions.col(motion.corners++) = place;
            moved += place - mesh.nodes[node];
        }
        // Written so that what is no number is left out.
        if (!((moved / motion.corners).norm() > threshold) || !motion.positions.allFinite()) {
            continue;
        }
        const LeastExtents extents{settings.minimumThicknessRatio, settings.minimumHalfExtent};
        const ElementSolid solid = elementSolid(mesh, e, motion, components.section[i], extents);
        const OrientedBox& box = solid.sound.box;
        live.pieces.push_back({box, box.centre, mass, components.volume[i], static_cast<std::uint32_t>(at(components.of[i]))});
        live.mass += mass;
        live.volume += components.volume[i];
    }
    return live;
}

}  // namespace rubble
