#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/accuracy/settled_world.h"
#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Where the corners of live elements are at one instant: interpolated between two FE states for elements alive at both; after the
/// last one, elements of released islands are where their bodies are and all others stay.
class ElementPlaces {
public:
    /// @param activity  as the policy sees it; must outlive this
    ElementPlaces(const FeResult& fe, const Activity& activity, const TrajectoryReader& trajectory, double time);
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
    std::vector<std::optional<Pose>> m_carried;  ///< [elements], of released islands since the last FE state
};

}  // namespace rubble
