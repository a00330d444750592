#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/analysis/accuracy/settled_world.h"
#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Where the corners of live elements are at one instant: those of islands that bodies carry are where their bodies are, and so
/// is what left them and is not born yet; others are interpolated between two FE states where alive at both, and stay after the
/// last one.
class ElementPlaces {
public:
    /// @param activity  as the policy sees it; must outlive this
    ElementPlaces(const FeResult& fe, const Activity& activity, const FragmentSet& fragments, const TrajectoryReader& trajectory,
                  double time);
    /// @param islands  as they are at that time
    ElementPlaces(const FeResult& fe, const Activity& activity, std::span<const CarriedIsland> islands, double time);

    bool alive(ElementIndex e) const { return m_activity.active(m_state, e); }
    /// m; not a number where the file has none.
    Vec3 place(ElementIndex e, std::uint32_t node) const;

private:
    const Activity& m_activity;
    std::size_t m_state = 0;
    double m_share = 0.0;
    std::shared_ptr<const FeState> m_now;
    std::shared_ptr<const FeState> m_next;
    std::vector<std::int32_t> m_carried;  ///< [elements], first corner in m_corners; -1: the FE result moves it
    std::vector<Vec3> m_corners;          ///< m, of carried elements, in the order of their nodes
    const Mesh& m_mesh;
};

}  // namespace rubble
