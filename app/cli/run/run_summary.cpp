#include "app/cli/run/run_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "app/cli/frame/measure_output.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/base/message.h"
#include "core/evidence/cautions.h"
#include "core/evidence/maps/run_map.h"
#include "core/simulation/health/passed_limits.h"

namespace rubble::cli {

namespace {

std::string fallenText(const Results& results) {
    const SimulationResult& run = *results.simulation;
    const std::vector<Fragment>& fragments = results.fragments->list;
    std::string text = "nothing: no element dies in this result, there are no fragments";
    if (!fragments.empty()) {
        const double mass = std::accumulate(fragments.begin(), fragments.end(), 0.0,
                                            [](double sum, const Fragment& fragment) { return sum + fragment.mass; });
        text = counted(static_cast<std::int64_t>(fragments.size()), "fragment", "fragments") + ", " + tonnesText(mass) + ", in " +
               counted(run.bodiesPeak, "body", "bodies");
    }
    if (run.islands.released > 0) {
        text += "; and " + counted(run.islands.released, "loose part", "loose parts") + " of the live structure, " +
                tonnesText(run.islands.releasedMass);
    }
    if (run.carried.islands > 0) {
        text += "; " + counted(run.carried.islands, "loose island", "loose islands") + ", " + tonnesText(run.carried.mass) +
                ", moved by the engine from when they came loose";
    }
    return text;
}

std::string placeText(const std::optional<DebrisFigures>& figures) {
    if (!figures) {
        return "cannot be measured: a piece lies too far away, or its place is no number";
    }
    const MeasureSettings settings;
    return "on " + numberOrDash(figures->footprintArea) + " m2; " + percentOrDash(settings.runOutShare) +
           " of the mass within a run-out of " + numberOrDash(figures->runOut) + " m; " + numberOrDash(figures->pileHeight) +
           " m high at most";
}

std::string courseText(const Results& results) {
    const SimulationResult& run = *results.simulation;
    const double wall = std::accumulate(results.wallSeconds.begin(), results.wallSeconds.end(), 0.0);
    std::string text =
        englishNumber(run.firstTime) + " s to " + englishNumber(run.endTime) + " s in " + englishNumber(wall) + " s of wall time";
    const double factor = run.stepTimes.realTimeFactor;
    if (std::isfinite(factor) && factor > 0.0) {
        text += "; " + englishNumber(factor) + " times real time while fragments are born";
    }
    return text;
}

/// The worst breach of the limit with the gravest grade, of equal ones that passed for longest; null if no limit was passed.
const HealthBreach* gravestBreach(const HealthReport& health) {
    const std::vector<PassedLimit> limits = passedLimits(health.breaches);
    const auto gravest = std::max_element(limits.begin(), limits.end(), [&](const PassedLimit& a, const PassedLimit& b) {
        return a.grade != b.grade ? a.grade < b.grade : heldFor(a, health.breaches) < heldFor(b, health.breaches);
    });
    return gravest == limits.end() ? nullptr : &health.breaches[gravest->worst];
}

/// The gravest limit with its numbers, of the others what they are.
std::string healthText(const HealthReport& health, const io::Taint& taint) {
    const HealthBreach* gravest = gravestBreach(health);
    if (!gravest) {
        return "no limit was passed";
    }
    std::set<std::string> others;
    for (const HealthBreach& breach : health.breaches) {
        if (breach.check != gravest->check) {
            others.insert(englishText(healthCheckTitle(breach.check)));
        }
    }
    const std::string state = taint.acknowledgement ? "acknowledged"
                              : taint.tainted()     ? "tainted, not acknowledged"
                                                    : std::string(healthGradeName(taint.grade));
    std::string text = counted(static_cast<std::int64_t>(taint.limits), "limit", "limits") + " passed, " + state + ": " +
                       englishText(gravest->what);
    for (const std::string& other : others) {
        text += (&other == &*others.begin() ? "; also: " : ", ") + other;
    }
    return text;
}

/// Of the gravest breach; without one of the first finding, as what is wrong early is wrong in all that follows.
std::string remedyText(const HealthReport& health, const Findings& findings) {
    if (const HealthBreach* gravest = gravestBreach(health)) {
        return englishText(gravest->remedy);
    }
    const auto first = std::find_if(findings.list().begin(), findings.list().end(),
                                    [](const Finding& finding) { return !finding.remedy.empty(); });
    return first == findings.list().end() ? std::string() : englishText(first->what) + ": " + englishText(first->remedy);
}

std::string filesText(const RunReport& report) {
    std::string text = report.runPath.empty() ? "the run is not kept (--out RUN.h5 keeps it)" : report.runPath;
    for (const std::string& path : report.files) {
        text += ", " + path;
    }
    return text;
}

}  // namespace

std::optional<DebrisFigures> figuresAtEnd(const io::OpenedCase& subject, const Results& results, Debris debris) {
    const MappedRun mapped{subject.inputs.fe.get(), nullptr,         results.fragments, results.simulation,
                           subject.inputs.terrain,  subject.scenario};
    try {
        return measureDebris(std::move(debris), CollapsePlan(*results.fragments, subject.inputs.fe->mesh()), groundOf(mapped), {})
            .figures;
    } catch (const UsageError&) {
        return std::nullopt;
    }
}

void printSummary(std::ostream& out, const RunReport& report, const std::optional<DebrisFigures>& figures) {
    const SimulationResult& run = *report.results.simulation;
    out << report.subject.fePath << ", scenario \"" << report.subject.scenarioName << "\"\n";
    FactList facts;
    facts.add("fell", fallenText(report.results));
    if (!report.results.fragments->list.empty()) {
        facts.add("lies", placeText(figures));
    }
    facts.add("simulated", courseText(report.results) + "; " + englishText(singleRunCaution().what));
    facts.add("at rest", percentOrDash(run.asleepAtEnd) + " of the bodies; " + englishInteger(run.stillMoving) + " still move");
    facts.add("health", healthText(run.health, report.taint));
    const auto findings = static_cast<std::int64_t>(report.findings.list().size());
    facts.add("findings", findings == 0 ? "none" : englishInteger(findings) + "; --tables lists each with its remedy");
    if (const std::string remedy = remedyText(run.health, report.findings); !remedy.empty()) {
        facts.add("first to do", remedy);
    }
    facts.add("files", filesText(report));
    facts.print(out);
    out << "  --tables prints every table, --json every number.\n";
}

}  // namespace rubble::cli
