#pragma once

#include <iosfwd>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Speed of each fragment in a frame, m/s [fragments]: of the centre of the body that carries it. NaN before its hand-over, after
/// its end, and once its last body has left. A body that the frame does not have yet counts as it was handed over.
/// @param carriers  in the order in which they were added
std::vector<double> fragmentSpeeds(const FragmentSet& fragments, std::span<const Carrier> carriers, const TrajectoryFrame& frame);

/// Fragments together in one frame of a run, each with the speed of the body that carries it.
struct HistoryPoint {
    double time = 0.0;          ///< s
    std::size_t fragments = 0;  ///< of them, those that bodies carry then
    double mass = 0.0;          ///< kg, of those
    double height = 0.0;        ///< m, of their common centre of mass
    double speed = 0.0;         ///< m/s: root of the mean square, weighed by mass
    double topSpeed = 0.0;      ///< m/s, of the fastest
    double kinetic = 0.0;       ///< J, without spin
    double potential = 0.0;     ///< J, of their weight above `level`
};

/// Follows fragments through all frames in which any of them is carried, in the order of time.
/// @param which    ascending
/// @param gravity  m/s2
/// @param level    m: potential energy counts from there
/// Throws Cancelled and what the trajectory throws.
std::vector<HistoryPoint> fragmentHistory(const FragmentSet& fragments, const TrajectoryReader& trajectory,
                                          std::span<const FragmentId> which, double gravity, double level,
                                          const Execution& execution);

/// Writes a history as CSV, one row a frame: `time_s`, `fragments`, `mass_kg`, `height_m`, `speed_m_s`, `top_speed_m_s`,
/// `kinetic_energy_j`, `potential_energy_j`.
void writeHistoryCsv(std::span<const HistoryPoint> points, std::ostream& out);

}  // namespace rubble
