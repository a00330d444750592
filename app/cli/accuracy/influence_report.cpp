#include "app/cli/accuracy/influence_report.h"

#include <cmath>

#include "app/cli/frame/measure_output.h"
#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

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
        if (row.overFloor[m] > row.overFloor[most] || std::isnan(row.overFloor[most])) {
            most = m;
        }
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
    Findings findings = io::allFindings(subject, {});
    findings.append(report.findings);
    object["warnings"] = findingsJson(findings);
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
    if (!report.findings.empty()) {
        printFindings(out, report.findings);
    }
}

TextTable InfluenceOutput::table() const {
    std::vector<TextTable::Column> columns{{"effect", "effect"}, {"is", "state"}, {"change", "standing"}};
    forEachMeasure([&](Measure measure, std::size_t) {
        columns.push_back({std::string(measureTitle(measure)), std::string(measureKey(measure))});
    });
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
