#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/fe/components.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble::render {

/// What a quantity may be, bounds included; unset: no bound.
struct FilterRange {
    std::optional<double> low;
    std::optional<double> high;

    bool empty() const { return !low && !high; }
    /// What is no number lies within no bounds.
    bool holds(double value) const { return (!low || value >= *low) && (!high || value <= *high); }
    friend bool operator==(const FilterRange&, const FilterRange&) = default;
};

/// Which fragments are drawn: those that meet all of it. Structure that is active is drawn all the same.
struct FragmentFilter {
    FilterRange speed;      ///< m/s, at the time shown
    FilterRange mass;       ///< kg
    FilterRange size;       ///< m, longest side
    FilterRange birth;      ///< s, on the file's clock
    std::string component;  ///< empty: any

    bool empty() const { return speed.empty() && fixedEmpty(); }
    /// Nothing is asked that stays as it is for the whole run.
    bool fixedEmpty() const { return mass.empty() && size.empty() && birth.empty() && component.empty(); }
    friend bool operator==(const FragmentFilter&, const FragmentFilter&) = default;
};

/// The longest side of a fragment's box, m.
double longestSide(const Fragment& fragment);

/// Speeds of fragments as views have them, m/s [fragments]: those of a frame of their run, as fragmentSpeeds(), or those with which
/// they are born. @param data  with fragments, and with a run where there is a frame
std::vector<double> speedsShown(const SceneData& data, const TrajectoryFrame* frame);

/// Which fragments meet a filter, 1 for those [fragments].
/// @param components  may be null: their names are not known then, and none has the one that is asked for
/// @param speeds      m/s [fragments]; may be empty where the filter asks for none
std::vector<std::uint8_t> meeting(const FragmentFilter& filter, const FragmentSet& fragments, const Components* components,
                                  const std::vector<double>& speeds);

}  // namespace rubble::render
