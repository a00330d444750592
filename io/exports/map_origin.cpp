#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "core/base/csv_text.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/map_files.h"
#include "io/exports/provenance.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/run/run_json.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

nlohmann::json ledgerJson(const DebrisMap& map) {
    const MapLedger& ledger = map.ledger;
    nlohmann::json document = {{"fragments", ledger.fragments},
                               {"mass_kg", ledger.mass},
                               {"volume_m3", ledger.volume},
                               {"footprint_m2", ledger.footprintArea}};
    document["impact_energy_j"] = map.impacts ? nlohmann::json(ledger.impactEnergy) : nlohmann::json(nullptr);
    if (map.live) {
        document["live_structure"] = {{"elements", ledger.liveElements},
                                      {"mass_kg", ledger.liveMass},
                                      {"volume_m3", ledger.liveVolume},
                                      {"footprint_m2", ledger.liveFootprintArea}};
    }
    return document;
}

}  // namespace

MapOrigin mapOrigin(const RunReader& run, const DebrisMap& map, FrameKind shown) {
    return mapOrigin(run, map, shown, {});
}

MapOrigin mapOrigin(const RunReader& run, const DebrisMap& map, FrameKind shown, const std::vector<ShownFile>& drawn) {
    const RunOrigin& from = run.origin();
    MapOrigin origin;
    origin.frame = from.frame;
    origin.site = from.site;
    const std::string crs = MapPlace(from.frame, from.site).name();
    nlohmann::json document = nlohmann::json::parse(provenanceText(run));
    const std::vector<Caution> known = runCautions(standingAt(run, map.time));
    document["cautions"] = cautionsJson(known);
    for (const ShownFile& file : drawn) {
        document["map_outlines"].push_back({{"role", file.role}, {"path", file.path}, {"sha256", file.sha256}});
    }
    document["map"] = {{"time_s", map.time},
                       {"class", shownClass(shown)},
                       {"cell_m", map.cell},
                       {"crs", crs},
                       {"arrival_distance_m", map.arrivalDistance},
                       {"live_structure", map.live},
                       {"ledger", ledgerJson(map)}};
    if (map.live) {
        document["map"]["live_threshold_m"] = map.liveThreshold;
    }
    for (std::size_t c = 0; c < map.components.size(); ++c) {
        document["map"]["components"].push_back(map.components[c]);
    }
    origin.provenance = jsonText(document);
    origin.subject = mapSubject(from, {});
    const std::string cautions = pictureCautions(known);
    origin.facts = {{"RUBBLE_CLASS", std::string(shownClass(shown))},
                    {"RUBBLE_TIME_S", exactNumber(map.time)},
                    {"RUBBLE_CELL_M", exactNumber(map.cell)},
                    {"RUBBLE_CRS", crs},
                    {"RUBBLE_FE_SHA256", from.feSha256},
                    {"RUBBLE_TERRAIN_SHA256", from.terrainSha256.empty() ? "none" : from.terrainSha256},
                    {"RUBBLE_SCENARIO", from.scenarioName},
                    {"RUBBLE_RUN", from.fingerprint.hex()},
                    {"RUBBLE_BUILD", from.build},
                    {"RUBBLE_TAINTED", taintOf(run).tainted() ? "yes" : "no"},
                    {"RUBBLE_CAUTIONS", cautions.empty() ? "none" : cautions},
                    {"RUBBLE_LIVE_STRUCTURE",
                     map.live ? "layers of its own, moved farther than " + exactNumber(map.liveThreshold) + " m" : "left out"},
                    {"RUBBLE_MASS_KG", exactNumber(map.ledger.mass)},
                    {"RUBBLE_VOLUME_M3", exactNumber(map.ledger.volume)},
                    {"RUBBLE_FRAGMENTS", std::to_string(map.ledger.fragments)}};
    return origin;
}

std::string mapSubject(const RunOrigin& origin, const std::string& casePath) {
    const std::filesystem::path named(casePath.empty() ? origin.fePath : casePath);
    return named.filename().string() + " · " + origin.scenarioName;
}

std::string inputsLine(const MapOrigin& origin) {
    std::string line;
    for (const auto& [key, value] : origin.facts) {
        if (key.starts_with("RUBBLE_INPUT")) {
            line += (line.empty() ? "inputs " : ", ") + value.substr(0, 16);
        }
    }
    for (const auto& [key, value] : origin.facts) {
        if (key == "RUBBLE_BUILD") {
            line += (line.empty() ? "" : ", ") + std::string(shortBuild(value));
        }
    }
    return line;
}

void writeRunMap(const std::string& path, const RunMap& made, const std::vector<MapLayer>& layers, double contourSpacing,
                 const RunReader& run, const Execution& execution) {
    const MapOrigin origin = mapOrigin(run, made.map, made.shown);
    if (hasEnding(path, ".csv")) {
        writeMapCsv(path, made.map, layers, origin, execution);
    } else if (hasEnding(path, ".gpkg")) {
        const std::shared_ptr<const FragmentSet> fragments = run.fragments();
        const MapFragments list{fragments.get(), &made.debris, run.elementIds(), made.arrivals, made.energies};
        writeMapPackage(path, made.map, list, contourSpacing, origin, execution);
    } else {
        writeMapTiff(path, made.map, layers, origin, execution);
    }
}

}  // namespace rubble::io
