#include "app/cli/influence_report.h"

#include <cmath>

#include "app/cli/text_output.h"

namespace rubble::cli {

namespace {

/// Titles of the measures for people, in the order of Measure.
constexpr std::array<std::string_view, measureCount> titles{"mass map",           "core IoU",           "footprint IoU",
                                                            "run-out [m]",        "height RMS [m]",     "mean height [m]",
                                                            "centroid shift [m]", "median distance [m]"};

template <class Visit>
void forEachMeasure(Visit visit) {
    for (std::size_t m = 0; m < measureCount; ++m) {
        visit(static_cast<Measure>(m), m);
    }
}

std::string numberOrDash(double number) {
    return std::isfinite(number) ? englishNumber(number) : "-";
}

std::string percent(double share) {
    return std::isfinite(share) ? englishNumber(100.0 * share) + " %" : "-";
}

Json differenceJson(const DebrisDifference& difference) {
    Json object;
    forEachMeasure([&](Measure measure, std::size_t) { object[std::string(measureKey(measure))] = difference.of(measure); });
    Json rates = Json::array();
    for (std::size_t t = 0; t < difference.accuracy.size(); ++t) {
        rates.push_back({{"tolerance_m", difference.tolerances[t]}, {"share", difference.accuracy[t]}});
    }
    object["accuracy_rate"] = std::move(rates);
    return object;
}

Json figuresJson(const DebrisFigures& figures) {
    Json object;
    object["fragments"] = figures.fragments;
    object["mass_kg"] = figures.mass;
    object["footprint_m2"] = figures.footprintArea;
    object["core_m2"] = figures.coreArea;
    object["run_out_m"] = figures.runOut;
    object["mean_height_m"] = figures.meanHeight;
    object["pile_height_m"] = figures.pileHeight;
    object["centroid_m"] = {figures.centroid.x(), figures.centroid.y(), figures.centroid.z()};
    return object;
}

Json floorJson(const RepeatFloor& floor, double birthShift) {
    Json object;
    object["birth_shift_m"] = birthShift;
    object["repeats"] = Json::array();
    for (const RepeatRow& row : floor.repeats) {
        Json repeat;
        repeat["seed"] = row.seed;
        repeat["trajectory_hash"] = row.trajectoryHash.hex();
        repeat["health_breaches"] = row.breaches;
        repeat["figures"] = figuresJson(row.figures);
        repeat["difference"] = differenceJson(row.difference);
        object["repeats"].push_back(std::move(repeat));
    }
    object["largest"] = differenceJson(floor.largest);
    return object;
}

Json effectJson(const EffectInfluence& row) {
    Json object;
    object["effect"] = effectName(row.decision.kind);
    object["state"] = row.decision.on ? "on" : "off";
    object["reason"] = englishText(row.decision.reason);
    object["switchable"] = row.switchable;
    object["cannot"] = row.switchable ? Json() : Json(englishText(row.reason));
    object["done"] = row.done;
    if (!row.done) {
        return object;
    }
    object["standing"] = standingName(row.standing());
    object["difference"] = differenceJson(row.difference);
    forEachMeasure([&](Measure measure, std::size_t m) {
        const std::string key(measureKey(measure));
        object["over_floor"][key] = row.overFloor[m];
        object["standings"][key] = standingName(row.standings[m]);
    });
    object["other_figures"] = figuresJson(row.figures);
    object["trajectory_hash"] = row.trajectoryHash.hex();
    object["health_breaches"] = row.breaches;
    object["wall_s"] = row.wallSeconds;
    return object;
}

/// A difference and how it stands against the floor: "0.32 (3.1 x)", "0.09 (below)".
Cell measureCell(const EffectInfluence& row, Measure measure) {
    if (!row.done) {
        return {"", "", true};
    }
    const std::size_t m = static_cast<std::size_t>(measure);
    const double value = row.difference.of(measure);
    switch (row.standings[m]) {
        case Standing::Identical:
            return {"same", exactNumber(value), true};
        case Standing::Below:
            return {englishNumber(value) + " (below)", exactNumber(value), true};
        case Standing::Near:
        case Standing::Above:
            return {englishNumber(value) +
                        (std::isfinite(row.overFloor[m]) ? " (" + englishNumber(row.overFloor[m]) + " x)" : " (no floor)"),
                    exactNumber(value), true};
        case Standing::Undefined:
            return {numberOrDash(value), exactNumber(value), true};
    }
    return {};
}

/// What a reader should take from one row.
std::string sentenceOf(const EffectInfluence& row) {
    const std::string name(effectName(row.decision.kind));
    const std::string state = row.decision.on ? "on" : "off";
    if (!row.switchable) {
        return name + " (" + state + "): cannot be switched; " + englishText(row.reason);
    }
    if (!row.done) {
        return name + " (" + state + "): not simulated in its other state";
    }
    std::size_t most = 0;
    forEachMeasure([&](Measure, std::size_t m) {
        most = row.overFloor[m] > row.overFloor[most] || std::isnan(row.overFloor[most]) ? m : most;
    });
    switch (row.standing()) {
        case Standing::Identical:
            return name + " (" + state + "): changes nothing, bit for bit";
        case Standing::Below:
        case Standing::Undefined:
            return name + " (" + state + "): no change beyond the repeat floor";
        case Standing::Near:
        case Standing::Above:
            break;
    }
    std::string text = name + " (" + state + "): most in " + std::string(measureKey(static_cast<Measure>(most))) + ", ";
    text += std::isfinite(row.overFloor[most]) ? englishNumber(row.overFloor[most]) + " times the floor"
                                               : "where repeats do not differ";
    return text + (row.standing() == Standing::Near ? "; within twice the floor, which may be chance" : "");
}

void printFloor(std::ostream& out, const RepeatFloor& floor, double birthShift) {
    printHeading(out, "Repeat floor: the same run with births shifted by " + englishNumber(birthShift) + " m");
    std::vector<TextTable::Column> columns{{"", ""}};
    for (const std::string_view title : titles) {
        columns.push_back({std::string(title), ""});
    }
    for (const double tolerance : floor.largest.tolerances) {
        columns.push_back({"within " + englishNumber(tolerance) + " m", ""});
    }
    TextTable table(std::move(columns));
    const auto add = [&table](const std::string& name, const DebrisDifference& difference) {
        std::vector<Cell> cells{textCell(name)};
        forEachMeasure([&](Measure measure, std::size_t) { cells.push_back(numberCell(difference.of(measure))); });
        for (const double share : difference.accuracy) {
            cells.push_back({percent(share), "", true});
        }
        table.add(std::move(cells));
    };
    for (const RepeatRow& row : floor.repeats) {
        add("seed " + std::to_string(row.seed), row.difference);
    }
    if (!floor.repeats.empty()) {
        add("floor: worst of all pairs", floor.largest);
    }
    table.print(out);
}

void printFigures(std::ostream& out, const RepeatFloor& floor) {
    const DebrisFigures& figures = floor.figures;
    FactList facts;
    facts.add("fragments", englishInteger(figures.fragments) + ", " + tonnesText(figures.mass));
    facts.add("footprint", englishNumber(figures.footprintArea) + " m2, core " + englishNumber(figures.coreArea) + " m2");
    facts.add("run-out", numberOrDash(figures.runOut) + " m");
    facts.add("mean height of the mass", numberOrDash(figures.meanHeight) + " m, pile " + numberOrDash(figures.pileHeight) + " m");
    facts.add("health", floor.breaches == 0 ? "no breach" : englishInteger(floor.breaches) + " breaches: see rubble-cli run");
    facts.add("trajectory hash", floor.trajectoryHash.hex());
    facts.print(out);
}

}  // namespace

Json InfluenceOutput::json() const {
    Json object;
    object["scenario"] = subject.scenarioName;
    object["fe"] = {{"path", subject.fePath}, {"sha256", subject.inputs.fe->contents().sha256}};
    object["instant"] = report.instant == DebrisInstant::AtRest ? "rest" : "fe_end";
    object["complete"] = report.complete;
    object["base"] = Json();
    object["repeat_floor"] = Json();
    if (report.floor) {
        object["base"] = figuresJson(report.floor->figures);
        object["base"]["trajectory_hash"] = report.floor->trajectoryHash.hex();
        object["base"]["health_breaches"] = report.floor->breaches;
        object["repeat_floor"] = floorJson(*report.floor, settings.birthShift);
    }
    object["effects"] = Json::array();
    for (const EffectInfluence& row : report.effects) {
        object["effects"].push_back(effectJson(row));
    }
    object["warnings"] = findingsJson(allFindings(subject, {}));
    return object;
}

void InfluenceOutput::print(std::ostream& out) const {
    out << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
    printHeading(out, report.instant == DebrisInstant::AtRest ? "Debris at rest" : "Debris at the end of the FE result");
    if (!report.floor) {
        out << "  the run itself was not simulated to its end\n";
        return;
    }
    printFigures(out, *report.floor);
    printFloor(out, *report.floor, settings.birthShift);
    printHeading(out, "What each effect changes: with it less without it (times the floor)");
    table().print(out);
    for (const EffectInfluence& row : report.effects) {
        out << "  " << sentenceOf(row) << '\n';
    }
}

TextTable InfluenceOutput::table() const {
    std::vector<TextTable::Column> columns{{"effect", "effect"}, {"is", "state"}, {"change", "standing"}};
    forEachMeasure(
        [&](Measure measure, std::size_t m) { columns.push_back({std::string(titles[m]), std::string(measureKey(measure))}); });
    TextTable table(std::move(columns));
    for (const EffectInfluence& row : report.effects) {
        const std::string standing = row.done         ? std::string(standingName(row.standing()))
                                     : row.switchable ? "not simulated"
                                                      : "cannot be switched";
        std::vector<Cell> cells{textCell(std::string(effectName(row.decision.kind))), textCell(row.decision.on ? "on" : "off"),
                                textCell(standing)};
        forEachMeasure([&](Measure measure, std::size_t) { cells.push_back(measureCell(row, measure)); });
        table.add(std::move(cells));
    }
    return table;
}

}  // namespace rubble::cli
