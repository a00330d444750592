#include "app/cli/frame/health_output.h"

#include <cmath>

#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

Json breachJson(const HealthBreach& breach) {
    Json object;
    object["check"] = healthCheckName(breach.check);
    object["from_s"] = breach.from;
    object["to_s"] = breach.to;
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

void printWatched(std::ostream& out, const SimulationResult& result) {
    const HealthReport& health = result.health;
    FactList facts;
    facts.add("energy gained", number(100.0 * result.energy.drift) + " % of the work of gravity");
    facts.add("penetration over 0.5 s", number(health.penetrationSustained) + " m, " + number(100.0 * health.penetrationShare) +
                                            " % of a smallest side; " + number(100.0 * health.crowdShare) +
                                            " % of the bodies above 5 %");
    facts.add("fastest", number(health.fastestOverLimit) + " times what birth and fall allow");
    facts.add("farthest", number(health.farthest) + " m from the structure");
    facts.add("asleep at most", number(100.0 * health.asleepPeak) + " %");
    facts.add("contacts at most", englishInteger(health.contactsPeak) + " pairs");
    if (health.bodiesLost > 0) {
        facts.add("taken out", englishInteger(health.bodiesLost) + " bodies that were no number");
    }
    for (const HealthRemedy& remedy : health.remedies) {
        facts.add("smaller steps",
                  number(remedy.from) + " s to " + number(remedy.to) + " s, " + englishInteger(remedy.steps) + " steps halved");
    }
    facts.print(out);
}

}  // namespace

Json healthJson(const SimulationResult& result) {
    const HealthReport& health = result.health;
    Json object;
    object["breaches"] = Json::array();
    for (const HealthBreach& breach : health.breaches) {
        object["breaches"].push_back(breachJson(breach));
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

void printHealth(std::ostream& out, const SimulationResult& result, const io::Taint& taint) {
    const std::vector<HealthBreach>& breaches = result.health.breaches;
    printHeading(out, "Health: " + (breaches.empty() ? std::string("no limit was passed")
                                                     : englishInteger(static_cast<std::int64_t>(breaches.size())) + " breaches" +
                                                           (taint.tainted() ? ", tainted" : ", acknowledged")));
    if (!breaches.empty()) {
        TextTable table({{"check", ""},
                         {"from [s]", ""},
                         {"to [s]", ""},
                         {"worst", ""},
                         {"at [s]", ""},
                         {"limit", ""},
                         {"bodies", ""},
                         {"where", ""}});
        for (const HealthBreach& breach : breaches) {
            table.add({textCell(std::string(healthCheckName(breach.check))), numberCell(breach.from), numberCell(breach.to),
                       numberCell(breach.worst), numberCell(breach.worstAt), numberCell(breach.limit), integerCell(breach.bodies),
                       textCell(placeText(breach))});
        }
        table.print(out);
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
    session.err() << "rubble-cli: note: this run has " << englishInteger(static_cast<std::int64_t>(taint.breaches))
                  << (taint.breaches == 1 ? " health breach" : " health breaches") << " that nobody has acknowledged\n";
    if (!taint.problem.empty()) {
        session.err() << "  " << englishText(taint.problem) << '\n';
    }
    if (!runPath.empty() && taint.complete) {
        session.err() << "  rubble-cli acknowledge " << runPath << " --by NAME --note TEXT says that it may be used all the same\n";
    }
}

}  // namespace rubble::cli
