#include "core/evidence/ensembles/member_doubts.h"

#include <algorithm>

namespace rubble {

namespace {

struct MemberCounts {
    std::int64_t members = 0;
    std::int64_t moving = 0;
    std::int64_t unwell = 0;
    double mostMoving = 0.0;  ///< %, of the bodies of one member

    void add(const EnsembleReport& report) {
        for (const EnsembleMember* member : report.done()) {
            ++members;
            unwell += member->breaches > 0 ? 1 : 0;
            if (member->moving > 0 && report.instant == DebrisInstant::AtRest) {
                ++moving;
                const auto bodies = static_cast<double>(std::max<std::int64_t>(member->bodies, 1));
                mostMoving = std::max(mostMoving, 100.0 * static_cast<double>(member->moving) / bodies);
            }
        }
    }

    std::vector<MemberDoubt> doubts() const {
        std::vector<MemberDoubt> found;
        if (moving > 0) {
            found.push_back({{"ensemble.moving",
                              "not all at rest: bodies still moved at the end of {0} of {1} members, up to {2} % of them",
                              {moving, members, mostMoving}},
                             {"ensemble.moving.remedy", "raise settle_time until all members lie", {}}});
        }
        if (unwell > 0) {
            found.push_back({{"ensemble.health", "{0} of {1} members passed limits of health", {unwell, members}},
                             {"ensemble.health.remedy", "simulate one of them by itself and look at its health", {}}});
        }
        return found;
    }
};

}  // namespace

std::vector<MemberDoubt> memberDoubts(const EnsembleReport& report) {
    MemberCounts counts;
    counts.add(report);
    return counts.doubts();
}

std::vector<MemberDoubt> memberDoubts(std::span<const Hypothesis> causes) {
    MemberCounts counts;
    for (const Hypothesis& cause : causes) {
        counts.add(*cause.ensemble);
    }
    return counts.doubts();
}

bool allAtRest(const EnsembleReport& report) {
    const std::vector<const EnsembleMember*> done = report.done();
    return std::none_of(done.begin(), done.end(), [](const EnsembleMember* member) { return member->moving > 0; });
}

std::string ensembleClass(const EnsembleReport& report) {
    if (report.instant != DebrisInstant::AtRest) {
        return "simulated, at the end of the FE result";
    }
    return allAtRest(report) ? "simulated, at rest" : "simulated, where each member ended: not all at rest";
}

Findings findingsOfMembers(std::span<const Hypothesis> causes) {
    Findings all;
    for (const Hypothesis& cause : causes) {
        const std::vector<MemberDoubt> own = memberDoubts(*cause.ensemble);
        for (const Finding& finding : cause.ensemble->findings.list()) {
            const bool counted =
                std::any_of(own.begin(), own.end(), [&](const MemberDoubt& doubt) { return doubt.what.id == finding.what.id; });
            if (!counted) {
                all.add(finding.what, finding.remedy, finding.example, finding.count);
            }
        }
    }
    for (const MemberDoubt& doubt : memberDoubts(causes)) {
        all.add(doubt.what, doubt.remedy);
    }
    return all;
}

}  // namespace rubble
