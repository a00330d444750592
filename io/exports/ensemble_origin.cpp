#include "io/exports/ensemble_origin.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "core/base/csv_text.h"
#include "core/base/unknown.h"
#include "core/evidence/ensembles/member_doubts.h"
#include "core/evidence/ensembles/probability_map.h"
#include "io/json/ensemble_json.h"
#include "io/run/run_cautions.h"
#include "io/run/run_json.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

nlohmann::json membersJson(const EnsembleReport& report) {
    nlohmann::json members = nlohmann::json::array();
    for (const EnsembleMember* member : report.done()) {
        nlohmann::json drawn = nlohmann::json::object();
        for (const auto& [key, value] : member->drawn) {
            drawn[key] = value;
        }
        members.push_back({{"member", member->number},
                           {"drawn", std::move(drawn)},
                           {"trajectory_hash", member->trajectoryHash.hex()},
                           {"health_breaches", member->breaches}});
    }
    return members;
}

}  // namespace

std::string ensembleClass(const EnsembleReport& report) {
    return report.instant == DebrisInstant::AtRest ? "simulated, at rest" : "simulated, at the end of the FE result";
}

std::vector<Caution> ensembleCautions(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis) {
    std::vector<Caution> cautions = basis.cautions;
    for (const MemberDoubt& doubt : memberDoubts(report)) {
        cautions.push_back({"members", HealthGrade::Finding, doubt.what});
    }
    if (map.has(MapLayer::Probability)) {
        const std::vector<ConvergenceRow> rows = convergenceOf(report);
        cautions.push_back(ensembleCaution(report.done().size(), rows.empty() ? unknown : rows.back().probabilityError,
                                           rows.empty() ? unknown : rows.back().worstError));
    }
    if (const std::string named = unplacedSystem(basis.frame, basis.site); !named.empty()) {
        cautions.push_back(noPlaceCaution(named));
    }
    return cautions;
}

MapOrigin ensembleOrigin(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis) {
    MapOrigin origin;
    origin.frame = basis.frame;
    origin.site = basis.site;
    const MapPlace place(basis.frame, basis.site);
    const std::string& crs = place.name();
    const std::string counted = report.surface.withFallen ? "fragments and live structure that moved farther than " +
                                                                exactNumber(report.surface.liveThreshold) + " m"
                                                          : "fragments";
    nlohmann::json document;
    document["build"] = std::string(buildText());
    document["inputs"] = nlohmann::json::array();
    for (const EnsembleInput& input : basis.inputs) {
        document["inputs"].push_back({{"role", input.role}, {"path", input.path}, {"sha256", input.sha256}});
    }
    document["coordinates"] = std::string(place.site().words());
    document["ensemble"] = ensembleJson(report.settings);
    document["members"] = membersJson(report);
    document["map"] = {{"class", ensembleClass(report)},
                       {"cell_m", map.cell},
                       {"crs", crs},
                       {"debris", counted},
                       {"members", map.members},
                       {"hypotheses", map.hypotheses},
                       {"thresholds_m", map.thresholds}};
    const std::vector<Caution> cautions = ensembleCautions(report, map, basis);
    document["cautions"] = cautionsJson(cautions);
    origin.provenance = jsonText(document);
    for (const EnsembleInput& input : basis.inputs) {
        if (input.role == "fe") {
            origin.subject += (origin.subject.empty() ? "" : ", ") + std::filesystem::path(input.path).filename().string();
        }
    }
    origin.facts = {{"RUBBLE_CLASS", ensembleClass(report)},
                    {"RUBBLE_CELL_M", exactNumber(map.cell)},
                    {"RUBBLE_CRS", crs},
                    {"RUBBLE_MEMBERS", std::to_string(map.members)},
                    {"RUBBLE_DEBRIS", counted},
                    {"RUBBLE_CAUTIONS", cautions.empty() ? "none" : pictureCautions(cautions)},
                    {"RUBBLE_BUILD", std::string(buildText())}};
    for (std::size_t t = 0; t < map.thresholds.size(); ++t) {
        origin.facts.emplace_back("RUBBLE_HEIGHT_" + std::to_string(t + 1) + "_M", exactNumber(map.thresholds[t]));
    }
    for (std::size_t i = 0; i < basis.inputs.size(); ++i) {
        origin.facts.emplace_back("RUBBLE_INPUT_" + std::to_string(i + 1) + "_SHA256", basis.inputs[i].sha256);
    }
    return origin;
}

}  // namespace rubble::io
