#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/scenario/registration.h"

namespace rubble {

/// A place that was found in a survey and in the case.
struct PlacePair {
    std::string name;
    Vec3 surveyed = Vec3::Zero();  ///< m, local, where the survey has it as its coordinates say
    Vec3 placed = Vec3::Zero();    ///< m, local, where it belongs
    /// m, standard deviation of where it belongs along each axis, as whoever measured it states; unset: not stated.
    std::optional<double> deviation = std::nullopt;
    friend bool operator==(const PlacePair&, const PlacePair&) = default;
};

/// The rigid move of least squares that brings surveyed places to where they belong.
struct PairFit {
    Registration registration;
    std::vector<Vec3> residuals;  ///< m, where they belong less where they come to [pairs]
    double scale = 1.0;           ///< lengths among the places by those among the surveyed; a rigid move leaves them as they are
    Findings findings;            ///< a scale that speaks of another unit, a pair that fits badly
};

/// Fits by the singular values of the pairs (Kabsch 1976; Umeyama 1991), without a scale. The error is what the residuals allow at
/// the corners of a box, with what the control points are stated to be off by themselves: points measured together may be off
/// together, which no residual shows, so that their mean square is added whole (ASPRS Positional Accuracy Standards, edition 2,
/// 2023). Of three pairs on an equal footing three of nine numbers are left to judge by.
/// @param site  m, local, what the move must hold for; empty: the pairs themselves
/// Throws UsageError (fewer than three pairs, numbers that are none, pairs in one place or on a line).
PairFit fitPairs(std::span<const PlacePair> pairs, const Aabb& site);

}  // namespace rubble
