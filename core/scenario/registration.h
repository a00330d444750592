#pragma once

#include <cstdint>
#include <optional>

#include "core/base/geometry.h"

namespace rubble {

/// How a survey lies in a case beyond what its coordinates say: a rigid move within the local frame, where it came from and how
/// well it is known.
struct Registration {
    Vec3 turn = Vec3::Zero();   ///< rad, the angle along its axis
    Vec3 about = Vec3::Zero();  ///< m, the turn is about it
    Vec3 shift = Vec3::Zero();  ///< m
    std::int64_t pairs = 0;     ///< points that somebody found in the survey and in the case; 0: none were used
    double pairsLeft = 0.0;     ///< m, root mean square of their distances once moved
    std::int64_t fitted = 0;    ///< points of what did not move that it was fitted by; 0: it was not
    double fitBefore = 0.0;     ///< m, root mean square of their distances to the surfaces of the case before
    double fitLeft = 0.0;       ///< m, the same once moved
    /// m, standard deviation of the control points themselves along each axis, which is part of the error; unset: nobody stated it.
    std::optional<double> control = std::nullopt;
    /// m, standard deviation by which a place may still be off along each axis; unset: not known.
    std::optional<double> error = std::nullopt;

    Mat3 rotation() const;
    Vec3 operator()(const Vec3& place) const { return about + shift + rotation() * (place - about); }
    /// Where a place came from.
    Vec3 back(const Vec3& place) const { return about + rotation().transpose() * (place - about - shift); }
    friend bool operator==(const Registration&, const Registration&) = default;
};

/// Moves by `first` and then by a turn about a place and a shift. What is known of either stays as `first` has it.
Registration movedOn(const Registration& first, const Mat3& turn, const Vec3& about, const Vec3& shift);

/// The box around where the corners of a box came from; an empty one stays empty.
Aabb boxBack(const Registration& registration, const Aabb& box);

}  // namespace rubble
