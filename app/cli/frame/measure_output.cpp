#include "app/cli/frame/measure_output.h"

#include <array>
#include <cmath>

#include "app/cli/frame/text_output.h"

namespace rubble::cli {

std::string_view measureTitle(Measure measure) {
    static constexpr std::array<std::string_view, measureCount> titles{
        "mass map",       "core IoU",        "footprint IoU",      "run-out [m]",
        "height RMS [m]", "mean height [m]", "centroid shift [m]", "median distance [m]"};
    return titles[static_cast<std::size_t>(measure)];
}

std::string numberOrDash(double number) {
    return std::isfinite(number) ? englishNumber(number) : "-";
}

std::string percentOrDash(double share) {
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

void printFloor(std::ostream& out, const RepeatFloor& floor, double birthShift) {
    printHeading(out, "Repeat floor: the same run with births shifted by " + englishNumber(birthShift) + " m");
    std::vector<TextTable::Column> columns{{"", ""}};
    forEachMeasure([&](Measure measure, std::size_t) { columns.push_back({std::string(measureTitle(measure)), ""}); });
    for (const double tolerance : floor.largest.tolerances) {
        columns.push_back({"within " + englishNumber(tolerance) + " m", ""});
    }
    TextTable table(std::move(columns));
    const auto add = [&table](const std::string& name, const DebrisDifference& difference) {
        std::vector<Cell> cells{textCell(name)};
        forEachMeasure([&](Measure measure, std::size_t) { cells.push_back(numberCell(difference.of(measure))); });
        for (const double share : difference.accuracy) {
            cells.push_back({percentOrDash(share), "", true});
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

}  // namespace rubble::cli
