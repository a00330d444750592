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

namespace {

void countBodies(RunStanding& standing, const RunReader& run, const TrajectoryFrame& frame) {
    standing.bodies = 0;
    standing.moving = 0;
    for (const BodyRecord& body : run.bodies()) {
        if (const std::size_t i = at(body.body); !body.isIsland() && i < frame.states.size()) {
            standing.bodies += frame.states[i] != BodyState::Removed ? 1 : 0;
            standing.moving += frame.states[i] == BodyState::Awake ? 1 : 0;
        }
    }
}

}  // namespace

RunStanding standingOf(const RunReader& run) {
    const auto fragments = run.fragments();
    const std::size_t count = fragments ? fragments->size() : 0;
    RunStanding standing;
    if (const auto result = run.result()) {
        standing = standingOf(*result, count, taintOf(run).acknowledgement.has_value());
    }
    standing.unplaced = unplacedSystem(run.origin().frame, run.origin().site);
    standing.unsaidUnits = run.origin().unsaidUnits;
    const std::vector<Message>& opened = run.origin().placeDoubts;
    standing.placeDoubts.insert(standing.placeDoubts.begin(), opened.begin(), opened.end());
    standing.outgrown = run.outgrown();
    tellInputs(standing, run.findings(), run.origin().scenario.fragments.birthVelocity);
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
    countBodies(standing, run, *last);
    return standing;
}

RunStanding standingAt(const RunReader& run, double time) {
    RunStanding standing = standingOf(run);
    if (run.frameCount() == 0 || time >= run.frame(run.frameCount() - 1)->time) {
        return standing;
    }
    standing.earlier = time;
    countBodies(standing, run, frameAtTime(run, time));
    return standing;
}

}  // namespace rubble::io
