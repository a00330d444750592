#pragma once

#include <span>

#include "core/validation/drop_series.h"

namespace rubble {

/// A figure that each dropped body has.
struct DropFigure {
    const char* key;    ///< "run_out_m"
    const char* title;  ///< "run-out [m]"
    /// @param zero  m, of the local frame in the axes of the table
    double (*of)(const DropOutcome& body, const Vec3& zero);
};

/// Run-out, lateral place, fall, path, contacts, top speed and time on the way, then the place of the end.
std::span<const DropFigure> dropFigures();
/// How many of them, from the first, say nothing of places.
inline constexpr std::size_t dropFiguresOfWay = 7;

/// Whether a body has an end that figures count: it rests or still moves.
inline bool hasEnd(const DropOutcome& body) {
    return body.ending == Ending::AtRest || body.ending == Ending::Moving;
}

}  // namespace rubble
