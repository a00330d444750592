#include "io/run/run_cautions.h"

#include "core/base/error.h"
#include "io/run/acknowledgements.h"
#include "io/site/site_place.h"

namespace rubble::io {

std::string unplacedSystem(const Frame& frame, const Site& site) {
    try {
        return SitePlace(frame, site).system().empty() ? frame.crs : std::string();
    } catch (const UsageError&) {
        return frame.crs;  // control points that place nothing
    }
}

RunStanding standingOf(const RunReader& run) {
    const auto fragments = run.fragments();
    const std::size_t count = fragments ? fragments->size() : 0;
    RunStanding standing;
    if (const auto result = run.result()) {
        standing = standingOf(*result, count, taintOf(run).acknowledgement.has_value());
    }
    standing.unplaced = unplacedSystem(run.origin().frame, run.origin().site);
    standing.unsaidUnits = run.origin().unsaidUnits;
    standing.placeDoubts = run.origin().placeDoubts;
    standing.outgrown = run.outgrown();
    if (run.result()) {
        return standing;
    }
    standing.complete = false;
    standing.breaches = run.breaches();
    standing.fragments = static_cast<std::int64_t>(count);
    if (run.frameCount() == 0) {
        return standing;
    }
    const auto last = run.frame(run.frameCount() - 1);
    standing.reached = last->time;
    for (const BodyRecord& body : run.bodies()) {
        if (const std::size_t i = at(body.body); !body.isIsland() && i < last->states.size()) {
            standing.bodies += last->states[i] != BodyState::Removed ? 1 : 0;
            standing.moving += last->states[i] == BodyState::Awake ? 1 : 0;
        }
    }
    return standing;
}

}  // namespace rubble::io
