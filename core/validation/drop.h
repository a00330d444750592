#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/fe/loose_bodies.h"
#include "core/pipeline/pipeline.h"
#include "core/validation/watched_world.h"

namespace rubble {

/// How a body ended.
enum class Ending : std::uint8_t {
    AtRest,
    Moving,   ///< still awake at the end
    Left,     ///< where the terrain has no heights of its raster
    Lost,     ///< its place became no number
    Refused,  ///< the engine could not take it
};
/// "rest", "moving", "left", "lost", "refused"
std::string_view endingName(Ending ending);

/// Where one body went; places in the local frame.
struct DropOutcome {
    Ending ending = Ending::Refused;
    BodyTrace trace;
    double runOut = 0.0;   ///< m, horizontal distance from where it was let go to where it ended
    double fall = 0.0;     ///< m, by which it ended lower
    double lateral = 0.0;  ///< m, to the left of the mean direction of all bodies, from where it was let go
};

/// Where the axes of a body are that were those of the table when it was let go. @param now  of its trace
Pose placed(const LooseBody& body, const DropOutcome& outcome, const Pose& now);

/// What is wanted of the way of the bodies.
struct DropWatch {
    double samplesPerSecond = 0.0;  ///< of the path; 0: none
    std::vector<double> asked;      ///< [bodies] s after it is let go, at which the place is wanted; empty: none
};

struct DropResult {
    std::vector<DropOutcome> bodies;  ///< of the table
    Results results;
    std::int64_t count(Ending ending) const;
};

/// Lets bodies go and follows them to rest, in the same world and by the same pipeline as a collapse.
/// @param inputs  `fe` from contentsOf(), or read from a table of bodies
/// @param sink    takes the trajectory too; null: nobody does
/// Throws what the pipeline and the sink throw, and Cancelled.
DropResult drop(const Inputs& inputs, const Scenario& scenario, const DropWatch& watch, TrajectorySink* sink,
                const Execution& execution);

}  // namespace rubble
