#include "app/cli/accuracy/accuracy_report.h"

#include <algorithm>
#include <cmath>

#include "app/cli/accuracy/published_tables.h"
#include "app/cli/frame/measure_output.h"
#include "app/cli/frame/text_output.h"
#include "core/analysis/accuracy/accuracy_front.h"
#include "core/analysis/accuracy/sweep_table.h"

namespace rubble::cli {

namespace {

Json pointJson(const SweepRow& row) {
    Json object;
    object["setting"] = row.setting;
    for (const SweepColumn& column : sweepColumns()) {
        const double value = column.value(row);
        object[std::string(column.key)] = column.whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
    }
    return object;
}

Json predictionJson(const Prediction& prediction) {
    if (!prediction.known) {
        return {{"known", false}, {"reason", englishText(prediction.reason)}};
    }
    return {{"known", true},           {"low", prediction.low},       {"value", prediction.value},
            {"high", prediction.high}, {"points", prediction.points}, {"from_calibration", prediction.fromCalibration}};
}

Json spreadJson(const FloorSpread& spread) {
    Json object;
    object["pairs"] = spread.pairs;
    forEachMeasure([&](Measure measure, std::size_t m) {
        object[std::string(measureKey(measure))] = {
            {"least", spread.least[m]}, {"middle", spread.middle[m]}, {"largest", spread.largest[m]}};
    });
    return object;
}

Json detailJson(const AccuracyPoint& point, const Predictions* predictions) {
    Json object;
    object["setting"] = point.setting;
    object["trajectory_hash"] = point.trajectoryHash.hex();
    object["health_breaches"] = point.breaches;
    object["bodies_peak"] = point.bodiesPeak;
    object["kept"] = point.kept;
    object["difference"] = differenceJson(point.difference);
    forEachMeasure([&](Measure measure, std::size_t m) {
        object["standings"][std::string(measureKey(measure))] = standingName(point.standings[m]);
    });
    object["repeats"] = Json::array();
    for (const DebrisDifference& repeat : point.repeats) {
        object["repeats"].push_back(differenceJson(repeat));
    }
    object["fps_worst"] = point.cost.fpsWorst;
    object["others_share"] = point.cost.othersShare;
    object["threads"] = point.cost.threads;
    object["predicted"] = Json();
    if (predictions) {
        for (std::size_t w = 0; w < predictedCount; ++w) {
            object["predicted"][std::string(predictedKey(static_cast<Predicted>(w)))] = predictionJson((*predictions)[w]);
        }
    }
    return object;
}

/// What is not done.
std::vector<const AccuracyPoint*> openPoints(const AccuracyReport& report) {
    std::vector<const AccuracyPoint*> list;
    const auto add = [&list](const AccuracyPoint& point) {
        if (!point.done || !point.failure.empty()) {
            list.push_back(&point);
        }
    };
    add(report.reference);
    std::for_each(report.points.begin(), report.points.end(), add);
    return list;
}

/// What is not done, and why.
Json openJson(const AccuracyReport& report) {
    Json list = Json::array();
    for (const AccuracyPoint* point : openPoints(report)) {
        list.push_back({{"setting", point->setting},
                        {"bodies", point->bodies},
                        {"failure", point->failure.empty() ? Json() : Json(englishText(point->failure))}});
    }
    return list;
}

/// "0.12~": no larger than the floor.
Cell standingCell(const AccuracyPoint& point, Measure measure) {
    const double value = point.difference.of(measure);
    const Standing standing = point.standings[static_cast<std::size_t>(measure)];
    return {standing == Standing::Identical ? "same" : numberOrDash(value) + (standing == Standing::Below ? "~" : ""),
            exactNumber(value), true};
}

/// "12 to 18 (15)", or why nothing is said.
std::string predictionText(const Prediction& prediction) {
    return prediction.known ? englishNumber(prediction.value) + " (" + englishNumber(prediction.low) + " to " +
                                  englishNumber(prediction.high) + ")" + (prediction.fromCalibration ? " c" : "")
                            : "not known";
}

}  // namespace

TextTable AccuracyOutput::errorTable() const {
    TextTable table({{"setting", "setting"}, {"fragment", "fragment_id"}, {"element", "element_id"}, {"error [m]", "error_m"}});
    if (!report.reference.done) {
        return table;
    }
    const Results results = run(subject.inputs, subject.scenario, Stage::Fragments, {}, nullptr, Execution());
    const Mesh& mesh = subject.inputs.fe->mesh();
    for (const AccuracyPoint& point : report.points) {
        for (std::size_t f = 0; point.done && f < point.fragmentErrors.size(); ++f) {
            const ElementIndex element = results.fragments->list[f].element;
            table.add({textCell(point.setting), integerCell(static_cast<std::int64_t>(f)),
                       integerCell(mesh.elementIds[at(element)]), numberCell(point.fragmentErrors[f])});
        }
    }
    return table;
}

Json AccuracyOutput::json() const {
    Json object;
    object["scenario"] = subject.scenarioName;
    object["fe"] = {{"path", subject.fePath}, {"sha256", subject.inputs.fe->contents().sha256}};
    object["instant"] = report.instant == DebrisInstant::AtRest ? "rest" : "fe_end";
    object["complete"] = report.complete;
    object["machine"] = options.machine;
    object["cache"] = cacheFolder.empty() ? Json() : Json(cacheFolder);
    object["points"] = Json::array();
    for (const SweepRow& row : sweepRows(report)) {
        object["points"].push_back(pointJson(row));
    }
    object["details"] = Json::array();
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        if (report.points[i].done || !options.simulated) {
            object["details"].push_back(detailJson(report.points[i], i < predictions.size() ? &predictions[i] : nullptr));
        }
    }
    object["open"] = openJson(report);
    object["repeat_floor"] = Json();
    if (report.floor) {
        object["repeat_floor"] = floorJson(*report.floor, options.study.birthShift);
        object["repeat_floor"]["spread"] = spreadJson(report.spread);
    }
    object["table_1"] = publishedFpsJson(report);
    object["table_2"] = publishedAccuracyJson(report);
    object["check"] = Json();
    if (checks) {
        object["check"] = Json::array();
        for (const PredictionCheck& check : *checks) {
            object["check"].push_back({{"quantity", predictedKey(check.what)},
                                       {"points", check.points},
                                       {"unknown", check.unknown},
                                       {"held", check.held},
                                       {"coverage", check.coverage()},
                                       {"half_width", check.halfWidth}});
        }
    }
    Findings findings = io::allFindings(subject, {});
    findings.append(report.findings);
    object["warnings"] = findingsJson(findings);
    return object;
}

TextTable AccuracyOutput::measureTable() const {
    std::vector<TextTable::Column> columns{{"setting", ""}, {"bodies", ""}};
    forEachMeasure([&](Measure measure, std::size_t) { columns.push_back({std::string(measureTitle(measure)), ""}); });
    for (const double tolerance : options.study.measures.tolerances) {
        columns.push_back({"within " + englishNumber(tolerance) + " m", ""});
    }
    TextTable table(std::move(columns));
    const auto add = [&](std::string name, std::int64_t bodies, const DebrisDifference& difference, const AccuracyPoint* point) {
        std::vector<Cell> cells{textCell(std::move(name)), integerCell(bodies)};
        forEachMeasure([&](Measure measure, std::size_t) {
            cells.push_back(point ? standingCell(*point, measure) : numberCell(difference.of(measure)));
        });
        for (const double share : difference.accuracy) {
            cells.push_back({percentOrDash(share), "", true});
        }
        table.add(std::move(cells));
    };
    if (report.floor && !report.floor->repeats.empty()) {
        add(std::string(floorSetting), report.reference.bodies, report.floor->largest, nullptr);
    }
    for (const AccuracyPoint& point : report.points) {
        if (point.done) {
            add(point.setting, point.bodies, point.difference, &point);
        }
    }
    return table;
}

TextTable AccuracyOutput::spreadTable() const {
    const std::vector<AccuracyKind> kinds = accuracyKinds(options.study.measures.tolerances);
    std::vector<TextTable::Column> columns{{"setting", ""}, {"runs", ""}};
    for (const AccuracyKind& kind : kinds) {
        columns.push_back(
            {kind.tolerance ? "within " + englishNumber(*kind.tolerance) + " m" : std::string(measureTitle(kind.measure)), ""});
    }
    TextTable table(std::move(columns));
    for (const AccuracyPoint& point : report.points) {
        if (point.repeats.empty()) {
            continue;
        }
        std::vector<Cell> cells{textCell(point.setting), integerCell(static_cast<std::int64_t>(1 + point.repeats.size()))};
        for (const AccuracyKind& kind : kinds) {
            const auto range = accuracyRange(point, kind);
            const auto text = [&](double value) { return kind.tolerance ? percentOrDash(value) : numberOrDash(value); };
            cells.push_back({range ? text(range->first) + " to " + text(range->second) : "-", "", true});
        }
        table.add(std::move(cells));
    }
    return table;
}

TextTable AccuracyOutput::costTable() const {
    TextTable table({{"setting", ""},
                     {"bodies", ""},
                     {"wall [s]", ""},
                     {"ms/step", ""},
                     {"worst", ""},
                     {"live FPS", ""},
                     {"worst second", ""},
                     {"taken by others", ""}});
    const auto add = [&table](const AccuracyPoint& point) {
        if (point.done) {
            table.add({textCell(point.setting),
                       integerCell(point.bodies),
                       numberCell(point.cost.wallSeconds),
                       numberCell(point.cost.stepMeanMs),
                       numberCell(point.cost.stepWorstMs),
                       numberCell(point.cost.fps),
                       numberCell(point.cost.fpsWorst),
                       {percentOrDash(point.cost.othersShare), "", true}});
        }
    };
    add(report.reference);
    std::for_each(report.points.begin(), report.points.end(), add);
    return table;
}

TextTable AccuracyOutput::predictionTable() const {
    std::vector<TextTable::Column> columns{{"setting", ""}, {"bodies", ""}};
    for (const Predicted what : {Predicted::WallSeconds, Predicted::Fps, Predicted::MassMap, Predicted::CoreIou}) {
        columns.push_back({std::string(predictedKey(what)), ""});
        columns.push_back({"measured", ""});
    }
    TextTable table(std::move(columns));
    for (std::size_t i = 0; i < predictions.size(); ++i) {
        const AccuracyPoint& point = report.points[i];
        std::vector<Cell> cells{textCell(point.setting), integerCell(point.bodies)};
        const KnownPoint known = knownPoint(point, report);
        for (const Predicted what : {Predicted::WallSeconds, Predicted::Fps, Predicted::MassMap, Predicted::CoreIou}) {
            cells.push_back({predictionText(predictions[i][static_cast<std::size_t>(what)]), "", true});
            cells.push_back({point.done ? numberOrDash(known.of(what)) : "-", "", true});
        }
        table.add(std::move(cells));
    }
    return table;
}

TextTable AccuracyOutput::checkTable() const {
    TextTable table(
        {{"quantity", ""}, {"points", ""}, {"not known", ""}, {"in the interval", ""}, {"share", ""}, {"half width", ""}});
    for (const PredictionCheck& check : *checks) {
        table.add({textCell(std::string(predictedKey(check.what))),
                   integerCell(static_cast<std::int64_t>(check.points)),
                   integerCell(static_cast<std::int64_t>(check.unknown)),
                   integerCell(static_cast<std::int64_t>(check.held)),
                   {percentOrDash(check.coverage()), "", true},
                   {percentOrDash(check.halfWidth), "", true}});
    }
    return table;
}

void AccuracyOutput::print(std::ostream& out) const {
    out << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
    if (report.floor) {
        printHeading(
            out, report.instant == DebrisInstant::AtRest ? "The reference, debris at rest" : "The reference, debris at the FE end");
        printFigures(out, *report.floor);
        printFloor(out, *report.floor, options.study.birthShift);
        printHeading(out, "Accuracy: each setting less the reference (~ no larger than the floor, which says nothing)");
        measureTable().print(out);
        if (const TextTable spread = spreadTable(); spread.rows() > 0) {
            printHeading(out, "Spread of each setting: least to largest amount over its run and the repeats of it");
            spread.print(out);
        }
        printHeading(out, "Cost, one setting at a time");
        costTable().print(out);
        printHeading(out, "Table 1 of the published method: live FPS without and with clusters");
        publishedFpsTable(report).print(out);
        printHeading(out, "Table 2 of the published method: accuracy rates");
        publishedAccuracyTable(report).print(out);
    } else if (options.simulated) {
        out << "  the reference was not simulated to its end\n";
    }
    for (const AccuracyPoint* open : openPoints(report)) {
        if (options.simulated) {
            out << "  not done: " << open->setting << (open->failure.empty() ? "" : ": " + englishText(open->failure)) << '\n';
        }
    }
    if (!predictions.empty()) {
        printHeading(
            out, "Predicted from other points of this scene, with the interval that 80 % should lie in (c: from the calibration)");
        predictionTable().print(out);
    }
    if (checks) {
        printHeading(out, "How well the 80 % intervals hold: each of " + englishInteger(static_cast<std::int64_t>(knownPoints)) +
                              " points predicted from those of other settings");
        checkTable().print(out);
    }
    Findings findings = io::allFindings(subject, {});
    findings.append(report.findings);
    printFindings(out, findings);
}

}  // namespace rubble::cli
