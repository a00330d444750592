#include "io/exports/ensemble_origin.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/build.h"
#include "core/base/csv_text.h"
#include "core/base/unknown.h"
#include "core/evidence/ensembles/member_doubts.h"
#include "core/evidence/ensembles/probability_map.h"
#include "io/json/ensemble_json.h"
#include "io/json/scenario_json.h"
#include "io/run/run_cautions.h"
#include "io/run/run_json.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

/// @param cause  empty: there is one ensemble alone
void addMembers(nlohmann::json& members, const EnsembleReport& report, const std::string& cause) {
    for (const EnsembleMember* member : report.done()) {
        nlohmann::json drawn = nlohmann::json::object();
        for (const auto& [key, value] : member->drawn) {
            drawn[key] = value;
        }
        members.push_back({{"member", member->number},
                           {"drawn", std::move(drawn)},
                           {"trajectory_hash", member->trajectoryHash.hex()},
                           {"health_breaches", member->breaches}});
        if (!cause.empty()) {
            members.back()["cause"] = cause;
        }
    }
}

nlohmann::json membersOf(std::span<const Hypothesis> causes) {
    nlohmann::json members = nlohmann::json::array();
    for (const Hypothesis& cause : causes) {
        addMembers(members, *cause.ensemble, cause.name);
    }
    return members;
}

/// What maps and charts of ensembles say alike of what they were made from.
nlohmann::json documentOf(const EnsembleReport& report, const EnsembleBasis& basis, nlohmann::json members,
                          const std::vector<Caution>& cautions) {
    nlohmann::json document;
    document["build"] = std::string(buildText());
    document["inputs"] = nlohmann::json::array();
    for (const EnsembleInput& input : basis.inputs) {
        document["inputs"].push_back({{"role", input.role}, {"path", input.path}, {"sha256", input.sha256}});
    }
    document["scenes"] = nlohmann::json::array();
    for (const EnsembleBasis::Scene& scene : basis.scenes) {
        document["scenes"].push_back({{"name", scene.name}, {"settings", scenarioJson(scene.scenario)["settings"]}});
    }
    document["coordinates"] = std::string(MapPlace(basis.frame, basis.site).site().words());
    document["ensemble"] = ensembleJson(report.settings);
    document["members"] = std::move(members);
    document["cautions"] = cautionsJson(cautions);
    return document;
}

void addDoubts(std::vector<Caution>& cautions, const std::vector<MemberDoubt>& doubts) {
    for (const MemberDoubt& doubt : doubts) {
        cautions.push_back({"members", HealthGrade::Finding, doubt.what});
    }
}

void addPlaceCaution(std::vector<Caution>& cautions, const EnsembleBasis& basis) {
    if (const std::string named = unplacedSystem(basis.frame, basis.site); !named.empty()) {
        cautions.push_back(noPlaceCaution(named));
    }
}

MapOrigin originOfMembers(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis, nlohmann::json members,
                          const std::vector<Caution>& cautions);

}  // namespace

std::vector<Caution> ensembleCautions(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis) {
    std::vector<Caution> cautions = basis.cautions;
    addDoubts(cautions, memberDoubts(report));
    if (map.has(MapLayer::Probability)) {
        const std::vector<ConvergenceRow> rows = convergenceOf(report);
        cautions.push_back(ensembleCaution(report.done().size(), rows.empty() ? unknown : rows.back().probabilityError,
                                           rows.empty() ? unknown : rows.back().worstError));
    }
    addPlaceCaution(cautions, basis);
    return cautions;
}

std::vector<Caution> separationCautions(std::span<const Hypothesis> causes, const EnsembleBasis& basis) {
    std::vector<Caution> cautions = basis.cautions;
    addDoubts(cautions, memberDoubts(causes));
    addPlaceCaution(cautions, basis);
    return cautions;
}

MapOrigin ensembleOrigin(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis) {
    nlohmann::json members = nlohmann::json::array();
    addMembers(members, report, {});
    return originOfMembers(report, map, basis, std::move(members), ensembleCautions(report, map, basis));
}

MapOrigin separationOrigin(std::span<const Hypothesis> causes, const DebrisMap& map, const EnsembleBasis& basis) {
    return originOfMembers(*causes.front().ensemble, map, basis, membersOf(causes), separationCautions(causes, basis));
}

std::string causesProvenance(std::span<const Hypothesis> causes, const EnsembleBasis& basis) {
    nlohmann::json document = documentOf(*causes.front().ensemble, basis, membersOf(causes), separationCautions(causes, basis));
    document["class"] = ensembleClass(*causes.front().ensemble);
    return jsonText(document);
}

namespace {

MapOrigin originOfMembers(const EnsembleReport& report, const DebrisMap& map, const EnsembleBasis& basis, nlohmann::json members,
                          const std::vector<Caution>& cautions) {
    MapOrigin origin;
    origin.frame = basis.frame;
    origin.site = basis.site;
    const MapPlace place(basis.frame, basis.site);
    const std::string& crs = place.name();
    nlohmann::json document = documentOf(report, basis, std::move(members), cautions);
    const std::string counted = report.surface.withFallen ? "fragments and live structure that moved farther than " +
                                                                exactNumber(report.surface.liveThreshold) + " m"
                                                          : "fragments";
    document["map"] = {{"class", ensembleClass(report)},
                       {"cell_m", map.cell},
                       {"crs", crs},
                       {"debris", counted},
                       {"members", map.members},
                       {"hypotheses", map.hypotheses},
                       {"thresholds_m", map.thresholds}};
    origin.provenance = jsonText(document);
    std::string files;
    for (const EnsembleInput& input : basis.inputs) {
        if (input.role == "fe") {
            files += (files.empty() ? "" : ", ") + std::filesystem::path(input.path).filename().string();
        }
    }
    for (const EnsembleBasis::Scene& scene : basis.scenes) {
        origin.subject += (origin.subject.empty() ? "" : ", ") + scene.name;
    }
    origin.subject = origin.subject.empty() || origin.subject == files ? files : origin.subject + " (" + files + ")";
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

}  // namespace

}  // namespace rubble::io
