#pragma once

#include <memory>

#include "core/scenario/ensemble.h"
#include "core/validation/drop.h"
#include "core/validation/release.h"

namespace rubble {

/// Bodies that are let go again and again.
struct DropSeries {
    std::vector<LooseBody> bodies;  ///< in the local frame
    Frame frame;
    std::shared_ptr<const TerrainGrid> terrain;  ///< null: none
    Scenario scenario;                           ///< prepareForBodies() has seen it
    bool turned = false;                         ///< at random, anew in each repeat
    bool lifted = false;                         ///< out of the surface in which they begin
    bool apart = false;                          ///< they never meet
    std::int64_t repeats = 1;
    std::int64_t seed = 1;              ///< of the turns
    std::vector<VariedSetting> varied;  ///< drawn anew in each repeat, with the same seed
    DropWatch watch;
    double until = 0.0;  ///< s, simulated at least
};

/// One of them.
struct DropRepeat {
    std::vector<LooseBody> bodies;  ///< as they were let go
    DrawnValues drawn;
    ReleaseCount lifted;
    DropResult result;
    double seconds = 0.0;  ///< wall time of its simulation
};

/// What things fall on.
SiteSurface surfaceOf(const DropSeries& series);

/// Lets them go in one repeat. The same series and repeat give the same bits, however many repeats there are.
/// Throws UsageError for values that are no settings, and as drop().
DropRepeat dropOnce(const DropSeries& series, std::int64_t repeat, const Execution& execution);

/// Lets them go in all repeats, several at a time where there are threads for it. The same bits as one after another.
/// @return [repeats]  in order
/// Throws as dropOnce(), and Cancelled.
std::vector<DropRepeat> dropAll(const DropSeries& series, const Execution& execution);

}  // namespace rubble
