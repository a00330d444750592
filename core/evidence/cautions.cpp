#include "core/evidence/cautions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/evidence/photographs/match_doubts.h"

namespace rubble {

namespace {

std::string limitsText(std::size_t count) {
    return count == 1 ? std::string("1 limit of health") : englishInteger(static_cast<std::int64_t>(count)) + " limits of health";
}

/// The limit that was passed, or the gravest of them.
std::string gravestText(const std::vector<PassedLimit>& passed) {
    const auto gravest = std::max_element(passed.begin(), passed.end(),
                                          [](const PassedLimit& a, const PassedLimit& b) { return a.grade < b.grade; });
    return englishText(healthCheckTitle(gravest->check));
}

Message limitsPassed(const std::vector<PassedLimit>& passed, HealthGrade grade, bool acknowledged) {
    const std::vector<Argument> told{limitsText(passed.size()), gravestText(passed)};
    if (acknowledged) {
        return {"caution.acknowledged", "{0} passed, acknowledged: {1}", told};
    }
    if (grade == HealthGrade::Notice) {
        return passed.size() == 1 ? Message{"caution.limits_passed", "{0} passed, a notice: {1}", told}
                                  : Message{"caution.limits_passed", "{0} passed, all notices; the first: {1}", told};
    }
    return passed.size() == 1 ? Message{"caution.limits_passed", "{0} passed, a finding: {1}", told}
                              : Message{"caution.limits_passed", "{0} passed, the gravest a finding: {1}", told};
}

void addLimits(std::vector<Caution>& list, const RunStanding& run) {
    const std::vector<PassedLimit> passed = passedLimits(run.breaches);
    const HealthGrade grade = gravestGrade(run.breaches);
    if (passed.empty()) {
        return;
    }
    if (grade == HealthGrade::Tainted && !run.acknowledged) {
        const std::vector<Argument> told{limitsText(passed.size()), gravestText(passed)};
        list.push_back(
            {"tainted", grade,
             passed.size() == 1
                 ? Message{"caution.tainted", "tainted: {0} passed, {1}, and nobody vouches for the run", told}
                 : Message{"caution.tainted", "tainted: {0} passed, the gravest {1}, and nobody vouches for the run", told}});
    } else {
        list.push_back({"limits_passed", std::min(grade, HealthGrade::Finding), limitsPassed(passed, grade, run.acknowledged)});
    }
}

}  // namespace

Caution noPlaceCaution(const std::string& system) {
    return {
        "no_place",
        HealthGrade::Finding,
        {"caution.no_place",
         "the coordinate system \"{0}\" is named, but the model has no place in it: axes and coordinates are the model's, north "
         "is not known until Site… has two control points, or the frame an origin",
         {system}}};
}

Caution singleRunCaution() {
    return {"single_run",
            HealthGrade::Notice,
            {"caution.single_run",
             "one set of assumptions: what is not known of friction, restitution and births is not in these figures",
             {}}};
}

Caution ensembleCaution(std::size_t members, double mean, double worst) {
    const Message what =
        std::isfinite(mean) && std::isfinite(worst)
            ? Message{"caution.ensemble",
                      "members: {0}; the probability of a cell may be off by {1} in the mean and by {2} at most, one standard "
                      "error; that covers what was varied and nothing else",
                      {members, mean, worst}}
            : Message{"caution.ensemble_unknown",
                      "members: {0}; how far the probability of a cell may be off is not known, and nothing but what was varied "
                      "is in it",
                      {members}};
    return {"ensemble", HealthGrade::Finding, what};
}

std::vector<Message> placeDoubts(const Findings& findings) {
    constexpr std::array<std::string_view, 6> others{"cloud.height_unit_assumed",   "terrain.height_unit",
                                                     "terrain.height_unit_unknown", "terrain.short",
                                                     "simulation.terrain_ended",    "simulation.terrain_unread"};
    constexpr double filledMuch = 0.1;
    std::vector<Message> doubts;
    for (const Finding& finding : findings.list()) {
        const std::string& id = finding.what.id;
        const std::vector<Argument>& told = finding.what.arguments;
        const auto counted = [&](std::size_t i) {
            const auto* number = i < told.size() ? std::get_if<std::int64_t>(&told[i].value) : nullptr;
            return number != nullptr ? static_cast<double>(*number) : 0.0;
        };
        const bool filled = id == "terrain.filled" && counted(0) > filledMuch * counted(1);
        if (id.starts_with("site.") || filled || std::find(others.begin(), others.end(), id) != others.end()) {
            doubts.push_back(finding.what);
        }
    }
    return doubts;
}

std::vector<Message> motionDoubts(const Findings& findings) {
    std::vector<Message> doubts;
    for (const Finding& finding : findings.list()) {
        if (finding.what.id == "simulation.speed_held" || finding.what.id == "simulation.held_together") {
            doubts.push_back(finding.what);
        }
    }
    return doubts;
}

namespace {

/// A finding as a caution says it.
struct Reworded {
    std::string_view of;  ///< id of the finding
    Message caution;      ///< {0}: its count; {1}: the first argument of the finding, where it has one
};

std::vector<Message> reworded(const Findings& findings, std::span<const Reworded> known) {
    std::vector<Message> told;
    for (const Finding& finding : findings.list()) {
        for (const Reworded& each : known) {
            if (finding.what.id == each.of) {
                Message message = each.caution;
                message.arguments.emplace_back(finding.count);
                if (!finding.what.arguments.empty()) {
                    message.arguments.push_back(finding.what.arguments.front());
                }
                told.push_back(std::move(message));
            }
        }
    }
    return told;
}

}  // namespace

std::vector<Message> assumedMasses(const Findings& findings) {
    static const std::array<Reworded, 5> known{{
        {"components.assumed_density",
         {"caution.assumed_density", "masses are assumed: no density is known of {0} elements, and {1} was taken", {}}},
        {"components.assumed_thickness",
         {"caution.assumed_thickness", "masses are assumed: no thickness is known of {0} elements, and {1} was taken", {}}},
        {"components.assumed_area",
         {"caution.assumed_area", "masses are assumed: no section is known of {0} elements, and {1} was taken", {}}},
        {"components.implausible_density",
         {"caution.implausible_density", "masses are doubtful: {0} elements have a density that no material has", {}}},
        {"fragments.no_volume_at_rest",
         {"caution.no_volume_at_rest",
          "masses are assumed: {0} elements without volume at rest weigh what their fragments would",
          {}}},
    }};
    return reworded(findings, known);
}

std::vector<Message> birthDoubts(const Findings& findings) {
    static const std::array<Reworded, 3> known{{
        {"fragments.no_velocity",
         {"caution.no_velocity", "the velocity of {0} elements at their death is not known: their fragments began at rest", {}}},
        {"fragments.part_velocity",
         {"caution.part_velocity", "of {0} elements the velocity of some corners is not known: that of the others was taken", {}}},
        {"fragments.death_time_outside",
         {"caution.death_time_outside",
          "the time of death of {0} elements lies outside the states that report it: that of the state was taken",
          {}}},
    }};
    return reworded(findings, known);
}

void tellInputs(RunStanding& standing, const Findings& findings, BirthVelocity velocity) {
    standing.assumed = assumedMasses(findings);
    standing.bornAtRest = velocity == BirthVelocity::Rest;
    standing.birthDoubts = birthDoubts(findings);
}

std::vector<Caution> inputCautions(const std::string& unsaidUnits, const std::vector<Message>& placeDoubts) {
    std::vector<Caution> list;
    if (!unsaidUnits.empty()) {
        list.push_back(
            {"units_unsaid",
             HealthGrade::Finding,
             {"caution.units_unsaid",
              "nobody has said which units the FE result counts in: it would fit {0} as well, with other lengths, masses "
              "and times",
              {unsaidUnits}}});
    }
    for (const Message& doubt : placeDoubts) {
        list.push_back({"place_doubt", HealthGrade::Finding, doubt});
    }
    return list;
}

void addCautions(std::vector<Caution>& list, const std::vector<Caution>& more) {
    for (const Caution& caution : more) {
        const std::string words = englishText(caution.what);
        const bool there = std::any_of(list.begin(), list.end(), [&](const Caution& each) {
            return each.key == caution.key && englishText(each.what) == words;
        });
        if (!there) {
            list.push_back(caution);
        }
    }
}

RunStanding standingOf(const SimulationResult& result, std::size_t fragments, bool acknowledged) {
    RunStanding standing;
    standing.reached = result.endTime;
    standing.fragments = static_cast<std::int64_t>(fragments);
    standing.bodies = result.bodiesPeak;
    standing.moving = result.stillMoving;
    standing.breaches = result.health.breaches;
    standing.acknowledged = acknowledged;
    standing.placeDoubts = placeDoubts(result.findings);
    standing.motionDoubts = motionDoubts(result.findings);
    return standing;
}

std::vector<Caution> runCautions(const RunStanding& run) {
    std::vector<Caution> list;
    addLimits(list, run);
    if (run.outgrown) {
        list.push_back({"other_settings",
                        HealthGrade::Finding,
                        {"caution.other_settings", "the case has other settings or inputs now than this run was made with", {}}});
    }
    addCautions(list, inputCautions(run.unsaidUnits, run.placeDoubts));
    if (run.bornAtRest) {
        list.push_back(
            {"born_at_rest",
             HealthGrade::Finding,
             {"caution.born_at_rest", "all debris began at rest, not with the velocity that the FE result gave it", {}}});
    }
    for (const Message& doubt : run.birthDoubts) {
        // Where all began at rest, no velocity was asked for.
        const bool ofVelocity = doubt.id.ends_with("_velocity");
        if (!run.bornAtRest || !ofVelocity) {
            list.push_back({"birth_doubt", HealthGrade::Finding, doubt});
        }
    }
    for (const Message& doubt : run.motionDoubts) {
        list.push_back({"motion_doubt", HealthGrade::Finding, doubt});
    }
    for (const Message& message : run.assumed) {
        list.push_back({"assumed", HealthGrade::Finding, message});
    }
    if (!run.complete) {
        list.push_back({"not_complete",
                        HealthGrade::Finding,
                        {"caution.not_complete",
                         "not complete: the run goes up to {0}, what comes later is not in it",
                         {{run.reached, "s"}}}});
    }
    if (run.moving > 0) {
        list.push_back({"still_moving", HealthGrade::Finding,
                        run.earlier ? Message{"caution.moving_then",
                                              "not all at rest: at {0}, the instant that is shown, {1} of {2} bodies moved",
                                              {{*run.earlier, "s"}, run.moving, run.bodies}}
                                    : Message{"caution.still_moving",
                                              "not all at rest: at {0}, the last instant, {1} of {2} bodies still moved",
                                              {{run.reached, "s"}, run.moving, run.bodies}}});
    }
    if (!run.unplaced.empty()) {
        list.push_back(noPlaceCaution(run.unplaced));
    }
    list.push_back(singleRunCaution());
    if (run.bodies > 0) {
        list.push_back({"bodies",
                        HealthGrade::Notice,
                        {"caution.bodies", "bodies that carry the fragments: {0} for {1}", {run.bodies, run.fragments}}});
    }
    return list;
}

std::vector<Caution> photographCautions(const Photograph& photograph, const CameraMatch* match, const RunStanding* run) {
    std::vector<Caution> list;
    if (match != nullptr) {
        for (MatchDoubt& doubt : matchDoubts(photograph, *match)) {
            list.push_back({doubt.key, HealthGrade::Finding, std::move(doubt.what)});
        }
    }
    if (run != nullptr && !photograph.time && (run->moving > 0 || !run->complete)) {
        list.push_back(
            {"not_at_rest",
             HealthGrade::Finding,
             {"caution.not_at_rest",
              "the photograph shows all at rest, but {0} of {1} bodies still move at {2}, where they are compared with it",
              {run->moving, run->bodies, {run->reached, "s"}}}});
    }
    return list;
}

std::string pictureCautions(const std::vector<Caution>& cautions) {
    std::string line;
    for (const Caution& caution : cautions) {
        if (caution.inPictures()) {
            line += (line.empty() ? "" : " · ") + englishText(caution.what);
        }
    }
    return line;
}

}  // namespace rubble
