#include <algorithm>
#include <cmath>
#include <limits>

#include "app/cli/exports/map_request.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "io/run/acknowledgements.h"

namespace rubble::cli {

namespace {

/// One layer in figures.
struct LayerFigures {
    std::size_t cells = 0;
    double least = std::numeric_limits<double>::quiet_NaN();
    double mean = std::numeric_limits<double>::quiet_NaN();
    double most = std::numeric_limits<double>::quiet_NaN();
};

LayerFigures figuresOf(const std::vector<double>& values) {
    LayerFigures figures;
    double sum = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            ++figures.cells;
            sum += value;
            figures.least = std::fmin(figures.least, value);
            figures.most = std::fmax(figures.most, value);
        }
    }
    if (figures.cells > 0) {
        figures.mean = sum / static_cast<double>(figures.cells);
    }
    return figures;
}

TextTable layerTable(const DebrisMap& map, const std::vector<MapLayer>& layers) {
    TextTable table(
        {{"layer", "layer"}, {"unit", "unit"}, {"cells", "cells"}, {"least", "least"}, {"mean", "mean"}, {"most", "most"}});
    for (const MapLayer layer : layers) {
        const MapLayerRow& row = mapLayerRow(layer);
        const LayerFigures figures = figuresOf(map.layer(layer));
        table.add({textCell(std::string(row.key)), textCell(std::string(row.unit)),
                   integerCell(static_cast<std::int64_t>(figures.cells)), numberCell(figures.least), numberCell(figures.mean),
                   numberCell(figures.most)});
    }
    return table;
}

Json mapJson(const RunMap& made, const std::vector<MapLayer>& layers) {
    const MapLedger& ledger = made.map.ledger;
    Json object;
    object["time_s"] = made.map.time;
    object["interpolated"] = made.shown == FrameKind::Interpolated;
    object["cell_m"] = made.map.cell;
    object["cells"] = made.map.cells.size();
    object["fragments"] = ledger.fragments;
    object["mass_kg"] = ledger.mass;
    object["volume_m3"] = ledger.volume;
    object["footprint_m2"] = ledger.footprintArea;
    object["impact_energy_j"] = made.map.impacts ? Json(ledger.impactEnergy) : Json();
    object["live_structure"] = Json();
    if (made.map.live) {
        object["live_structure"] = {{"threshold_m", made.map.liveThreshold},
                                    {"elements", ledger.liveElements},
                                    {"mass_kg", ledger.liveMass},
                                    {"volume_m3", ledger.liveVolume},
                                    {"footprint_m2", ledger.liveFootprintArea}};
    }
    object["layers"] = Json::array();
    for (const MapLayer layer : layers) {
        const LayerFigures figures = figuresOf(made.map.layer(layer));
        object["layers"].push_back({{"layer", mapLayerRow(layer).key},
                                    {"unit", mapLayerRow(layer).unit},
                                    {"cells", figures.cells},
                                    {"least", figures.least},
                                    {"mean", figures.mean},
                                    {"most", figures.most}});
    }
    return object;
}

void printMap(std::ostream& out, const RunMap& made, const std::vector<MapLayer>& layers) {
    const MapLedger& ledger = made.map.ledger;
    FactList facts;
    facts.add("time", englishNumber(made.map.time) + " s" +
                          (made.shown == FrameKind::Interpolated ? ", between two recorded instants" : ""));
    facts.add("cells", englishInteger(static_cast<std::int64_t>(made.map.cells.size())) + " of " + englishNumber(made.map.cell) +
                           " m" + (made.cellFrom > 0.0 ? ", by a typical fragment of " + englishNumber(made.cellFrom) + " m" : ""));
    facts.add("fragments", englishInteger(ledger.fragments) + ", " + tonnesText(ledger.mass) + ", " + englishNumber(ledger.volume) +
                               " m3 on " + englishNumber(ledger.footprintArea) + " m2");
    if (made.map.impacts) {
        facts.add("impact energy", englishNumber(ledger.impactEnergy) + " J");
    }
    if (made.map.live) {
        facts.add("live structure", englishInteger(ledger.liveElements) + " elements moved farther than " +
                                        englishNumber(made.map.liveThreshold) + " m, " + tonnesText(ledger.liveMass) + ", " +
                                        englishNumber(ledger.liveVolume) + " m3 on " + englishNumber(ledger.liveFootprintArea) +
                                        " m2");
    }
    printHeading(out, "Debris map");
    facts.print(out);
    layerTable(made.map, layers).print(out);
}

ExitCode map(const Arguments& arguments, Session& session) {
    const MapRequest request(arguments);
    const std::vector<std::string> files = arguments.values("--out");
    for (const std::string& path : files) {
        MapRequest::checkFormat("--out", path);
        checkOutputPath(path, std::vector<std::string>{arguments.operand()});
    }
    checkCsvPath(arguments, std::vector<std::string>{arguments.operand()});
    MapSubject subject = openMapSubject(arguments, session);
    const RunMap made = request.make(*subject.run, subject.inputs, session.execution());
    subject.instant = made.map.time;
    const std::vector<MapLayer> layers = request.layersOf(made.map);
    for (const std::string& path : files) {
        request.write(path, made, *subject.run, session);
    }
    writeCsv(arguments, layerTable(made.map, layers));
    Findings findings = subject.findings;
    findings.append(made.findings);
    conclude(
        arguments, session, subject, findings, [&] { return mapJson(made, layers); },
        [&](std::ostream& out) { printMap(out, made, layers); });
    return ExitCode::Ok;
}

}  // namespace

Command mapCommand() {
    const std::vector<Option> own{
        {"--out", "FILE", true, "a file to write: .tif, .gpkg, .csv or .png"},
        {"--time", "SECONDS", false, "instant on the file's clock, end, or fe_end: the last FE state (default: end)"},
    };
    const std::vector<Option> size{
        {"--size", "WxH", false, "pixels of a picture (default: 1600x1000, less where the map is of another shape)"}};
    return {
        "map",
        "RUN|FE|CASE",
        "debris by cells: height, mass, volume, pieces, arrival, impact energy",
        "Maps the debris of a recorded run at any instant, or simulates a case or FE file first. Fallen live structure has layers "
        "of its own.",
        joined({own, MapRequest::options(), size, siteOptions(), {csvOption("write the table of layers")}}),
        map};
}

}  // namespace rubble::cli
