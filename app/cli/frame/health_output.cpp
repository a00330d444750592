#include "app/cli/frame/health_output.h"

#include <algorithm>
#include <cmath>

#include "app/cli/frame/text_output.h"
#include "core/simulation/health/passed_limits.h"
#include "io/run/run_cautions.h"

namespace rubble::cli {

namespace {

/// A limit with the numbers of its worst breach and all its times.
Json limitJson(const PassedLimit& limit, const std::vector<HealthBreach>& breaches) {
    const HealthBreach& breach = breaches[limit.worst];
    Json object;
    object["check"] = healthCheckName(breach.check);
    object["grade"] = healthGradeName(limit.grade);
    object["why"] = englishText(gradeReason(breach));
    object["from_s"] = breaches[limit.breaches.front()].from;
    object["to_s"] = breaches[limit.breaches.back()].to;
    object["times_s"] = Json::array();
    for (const std::size_t i : limit.breaches) {
        object["times_s"].push_back({breaches[i].from, breaches[i].to});
    }
    object["worst_at_s"] = breach.worstAt;
    object["body"] = breach.body ? Json(at(*breach.body)) : Json();
    object["place_m"] = breach.body ? Json{breach.place.x(), breach.place.y(), breach.place.z()} : Json();
    object["worst"] = breach.worst;
    object["limit"] = breach.limit;
    object["bodies"] = breach.bodies;
    object["what"] = englishText(breach.what);
    object["remedy"] = englishText(breach.remedy);
    return object;
}

std::string number(double value) {
    return std::isfinite(value) ? englishNumber(value) : "-";
}

std::string placeText(const HealthBreach& breach) {
    if (!breach.body) {
        return "-";
    }
    return "body " + englishInteger(static_cast<std::int64_t>(at(*breach.body))) + " at (" + number(breach.place.x()) + ", " +
           number(breach.place.y()) + ", " + number(breach.place.z()) + ") m";
}

/// "1.2 to 3.4, 5", the intervals in which a limit was passed; many are counted.
std::string timesText(const PassedLimit& limit, const std::vector<HealthBreach>& breaches) {
    constexpr std::size_t listed = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(listed, limit.breaches.size()); ++i) {
        const HealthBreach& breach = breaches[limit.breaches[i]];
        text += (i > 0 ? ", " : "") + number(breach.from) + (breach.to > breach.from ? " to " + number(breach.to) : "");
    }
    if (limit.breaches.size() > listed) {
        text += " and " + englishInteger(static_cast<std::int64_t>(limit.breaches.size() - listed)) + " more";
    }
    return text;
}

void printWatched(std::ostream& out, const SimulationResult& result) {
    const HealthReport& health = result.health;
    FactList facts;
    facts.add("energy gained", number(100.0 * result.energy.drift) + " % of the work of gravity");
    facts.add("penetration over 0.5 s", number(health.penetrationSustained) + " m, " +
                                            englishText(healthMeasure(HealthCheck::Penetration, health.penetrationShare)) +
                                            (health.penetrationShare >= 1.0 ? " a smallest side; " : " of a smallest side; ") +
                                            number(100.0 * health.crowdShare) + " % of the bodies above 5 %");
    facts.add("fastest", number(health.fastestOverLimit) + " times what birth and fall allow");
    facts.add("farthest", number(health.farthest) + " m from the structure");
    facts.add("asleep at most", number(100.0 * health.asleepPeak) + " %");
    facts.add("contacts at most", englishInteger(health.contactsPeak) + " pairs");
    if (health.bodiesLost > 0) {
        facts.add("taken out", bodiesText(health.bodiesLost) + ": place or velocity was no number");
    }
    for (const HealthRemedy& remedy : health.remedies) {
        facts.add("smaller steps",
                  number(remedy.from) + " s to " + number(remedy.to) + " s, " + counted(remedy.steps, "step", "steps") + " halved");
    }
    facts.print(out);
}

}  // namespace

Json healthJson(const SimulationResult& result) {
    const HealthReport& health = result.health;
    Json object;
    object["breaches"] = Json::array();
    for (const PassedLimit& limit : passedLimits(health.breaches)) {
        object["breaches"].push_back(limitJson(limit, health.breaches));
    }
    object["energy_gain"] = result.energy.drift;
    object["penetration_sustained_m"] = health.penetrationSustained;
    object["penetration_sustained_share"] = health.penetrationShare;
    object["crowd_share"] = health.crowdShare;
    object["fastest_over_limit"] = health.fastestOverLimit;
    object["farthest_m"] = health.farthest;
    object["asleep_peak"] = health.asleepPeak;
    object["contacts_peak"] = health.contactsPeak;
    object["bodies_lost"] = health.bodiesLost;
    object["occupied_births"] = result.births.occupied;
    object["overlap_work_j"] = result.births.work;
    object["bulking_factor"] = result.bulkingFactor;
    object["remedies"] = Json::array();
    for (const HealthRemedy& remedy : health.remedies) {
        object["remedies"].push_back({{"from_s", remedy.from}, {"to_s", remedy.to}, {"steps", remedy.steps}});
    }
    object["digest"] = breachesDigest(result).hex();
    return object;
}

Json acknowledgedJson(const io::Taint& taint) {
    if (!taint.acknowledgement) {
        return nullptr;
    }
    return {{"by", taint.acknowledgement->by}, {"when", taint.acknowledgement->when}, {"note", taint.acknowledgement->note}};
}

Json cautionsJson(const std::vector<Caution>& cautions) {
    Json list = Json::array();
    for (const Caution& caution : cautions) {
        list.push_back({{"key", caution.key}, {"grade", healthGradeName(caution.grade)}, {"text", englishText(caution.what)}});
    }
    return list;
}

Json cautionsOf(const io::RunReader& run) {
    return cautionsJson(runCautions(io::standingOf(run)));
}

void printCautions(std::ostream& out, const std::vector<Caution>& cautions) {
    for (const Caution& caution : cautions) {
        if (caution.inPictures()) {
            out << "caution: " << englishText(caution.what) << '\n';
        }
    }
}

void printHealth(std::ostream& out, const SimulationResult& result, const io::Taint& taint) {
    const std::vector<HealthBreach>& breaches = result.health.breaches;
    const std::vector<PassedLimit> limits = passedLimits(breaches);
    const std::string state = taint.acknowledgement ? "acknowledged" : std::string(healthGradeName(taint.grade));
    printHeading(out, "Health: " + (limits.empty() ? std::string("no limit was passed")
                                                   : counted(static_cast<std::int64_t>(limits.size()), "limit", "limits") +
                                                         " passed, " + state));
    if (!limits.empty()) {
        TextTable table({{"check", ""},
                         {"grade", ""},
                         {"times [s]", ""},
                         {"worst", ""},
                         {"at [s]", ""},
                         {"limit", ""},
                         {"bodies", ""},
                         {"where", ""}});
        for (const PassedLimit& limit : limits) {
            const HealthBreach& breach = breaches[limit.worst];
            table.add({textCell(std::string(healthCheckName(breach.check))), textCell(std::string(healthGradeName(limit.grade))),
                       textCell(timesText(limit, breaches)), textCell(englishText(healthMeasure(breach.check, breach.worst))),
                       numberCell(breach.worstAt), textCell(englishText(healthMeasure(breach.check, breach.limit))),
                       integerCell(breach.bodies), textCell(placeText(breach))});
        }
        table.print(out);
        for (const PassedLimit& limit : limits) {
            out << "  " << healthGradeName(limit.grade) << ": " << englishText(healthCheckTitle(limit.check)) << ": "
                << englishText(gradeReason(breaches[limit.worst])) << '\n';
        }
    }
    printWatched(out, result);
    if (taint.acknowledgement) {
        out << "  acknowledged by " << taint.acknowledgement->by << ", " << taint.acknowledgement->when << ": "
            << taint.acknowledgement->note << '\n';
    }
}

void warnIfTainted(Session& session, const std::string& runPath, const io::Taint& taint) {
    if (!taint.tainted()) {
        return;
    }
    session.err() << "rubble-cli: note: this run is tainted: "
                  << counted(static_cast<std::int64_t>(taint.limits), "limit", "limits")
                  << " of health passed that nobody has acknowledged\n";
    if (!taint.problem.empty()) {
        session.err() << "  " << englishText(taint.problem) << '\n';
    }
    if (!runPath.empty() && taint.complete) {
        session.err() << "  rubble-cli acknowledge " << runPath << " --by NAME --note TEXT says that it may be used all the same\n";
    }
}

}  // namespace rubble::cli
