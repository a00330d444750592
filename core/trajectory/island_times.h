#pragma once

#include <cstddef>
#include <vector>

#include "core/fe/activity.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// When the engine took over what had come loose, told from the records of a run.
struct IslandTimes {
    /// What came to the engine at one instant.
    struct HandOver {
        double time = 0.0;         ///< s
        std::size_t islands = 0;   ///< that nothing had carried before
        std::size_t elements = 0;  ///< of those
        double mass = 0.0;         ///< kg
    };
    std::vector<HandOver> handOvers;  ///< by time
    std::vector<double> since;        ///< s, [elements], when the first island that had it came; infinity: none ever did

    bool carried(ElementIndex element) const;
    /// Elements that died while an island had them, for the interval that ends at each state.
    /// @param times  s, of the states
    std::vector<double> deathsByState(const Activity& activity, const std::vector<double>& times) const;
};

/// @param elements  of the model; records that name others are left out
IslandTimes islandTimes(const TrajectoryReader& trajectory, std::size_t elements);

}  // namespace rubble
