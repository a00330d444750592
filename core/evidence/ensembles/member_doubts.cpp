#include "core/evidence/ensembles/member_doubts.h"

#include <algorithm>

namespace rubble {

std::vector<MemberDoubt> memberDoubts(const EnsembleReport& report) {
    const std::vector<const EnsembleMember*> done = report.done();
    std::int64_t moving = 0;
    std::int64_t unwell = 0;
    double most = 0.0;
    for (const EnsembleMember* member : done) {
        unwell += member->breaches > 0 ? 1 : 0;
        if (member->moving > 0) {
            ++moving;
            most = std::max(
                most, 100.0 * static_cast<double>(member->moving) / static_cast<double>(std::max<std::int64_t>(member->bodies, 1)));
        }
    }
    std::vector<MemberDoubt> doubts;
    if (moving > 0 && report.instant == DebrisInstant::AtRest) {
        doubts.push_back({{"ensemble.moving",
                           "not all at rest: bodies still moved at the end of {0} of {1} members, up to {2} % of them",
                           {moving, done.size(), most}},
                          {"ensemble.moving.remedy", "raise settle_time until all members lie", {}}});
    }
    if (unwell > 0) {
        doubts.push_back({{"ensemble.health", "{0} of {1} members passed limits of health", {unwell, done.size()}},
                          {"ensemble.health.remedy", "simulate one of them by itself and look at its health", {}}});
    }
    return doubts;
}

}  // namespace rubble
