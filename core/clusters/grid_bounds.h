#pragma once

#include <array>
#include <cstdint>

#include "core/clusters/sizing.h"

namespace rubble {

/// Mean distances and bounds of the Basic Grid along x, y and z (DESIGN.md 2.2); nothing is chosen yet. Without a structural
/// component accuracyMax is the extent of all fragments, beyond which nothing is left to join. Without fragments all the rest is 0.
std::array<AxisSizing, 3> boundGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components,
                                    std::int64_t bodiesMax);

/// h_eff_min, the size at which one birth time would give the bodies allowed [m]: a guide.
double guideSize(double meanDistance, std::size_t fragments, std::int64_t bodiesMax);

/// Whether the smallest component is a bound: nested clusters keep within a component however large the grid.
inline bool boundByComponents(const GridSettings& settings) {
    return settings.grouping == Grouping::Axes || settings.acrossComponents;
}

/// Where the bounds along an axis leave the search no room.
enum class BoundConflict : std::uint8_t {
    None,
    Spacing,       ///< d exceeds h_acc_max
    FragmentSize,  ///< h_acc_min exceeds h_acc_max
};
BoundConflict conflictOf(const AxisSizing& axis);

/// Tells of a conflict of bounds, naming the largest fragment's element and the smallest component.
void reportConflict(const AxisSizing& sizing, int axis, const FragmentSet& fragments, const Mesh& mesh,
                    const Components& components, Findings& findings);

/// Tells where a size set by hand lies outside the bounds.
/// @param byComponents  the smallest component is one of them
void reportOutside(const AxisSizing& sizing, int axis, const FragmentSet& fragments, const Mesh& mesh, const Components& components,
                   bool byComponents, Findings& findings);

}  // namespace rubble
