#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/evidence/clouds/cloud_distance.h"

namespace rubble {

/// By how much a volume may be wrong, at 95 %.
struct CloudVolumeError {
    double random = 0.0;      ///< of both means in each cell: grows with the root of the number of cells
    double systematic = 0.0;  ///< of the registration: grows with their number; NaN: nobody stated how well the clouds lie
};

/// Volumes between two clouds over square cells, of distances from the level of detection on. Cubes of the unit of length. Where no
/// cell was measured all of them and their errors are NaN, for nothing is known of them.
struct CloudVolumes {
    double cell = 0.0;           ///< side
    std::int64_t cells = 0;      ///< that either cloud has points in
    std::int64_t measured = 0;   ///< with both and a level of detection
    std::int64_t fillCells = 0;  ///< where the second lies above
    std::int64_t cutCells = 0;   ///< where it lies below
    double fill = 0.0;
    double cut = 0.0;
    double undetectedFill = 0.0;  ///< of distances below the level of detection: not counted
    double undetectedCut = 0.0;   ///< likewise where the second lies below
    CloudVolumeError fillError;
    CloudVolumeError cutError;
    CloudVolumeError netError;

    double net() const { return fill - cut; }
    double undetected() const { return undetectedFill + undetectedCut; }
    double undetectedNet() const { return undetectedFill - undetectedCut; }
};

/// Adds up distances that were measured straight up, one at the middle of each cell.
/// @param registrationError  standard deviation by which one cloud may be out of place; unset: not known
CloudVolumes cloudVolumes(std::span<const CoreDistance> cells, double cell, const std::optional<double>& registrationError);

}  // namespace rubble
