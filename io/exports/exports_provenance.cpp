#include "io/run/acknowledgements.h"

#include <nlohmann/json.hpp>
#include "io/exports/exports.h"
#include "io/run/run_cautions.h"
#include "io/run/run_json.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

nlohmann::json healthText(const RunReader& run) {
    const Taint taint = taintOf(run);
    nlohmann::json text = {{"breaches", taint.limits}, {"grade", nullptr}, {"tainted", taint.tainted()}, {"acknowledged", nullptr}};
    if (taint.limits > 0) {
        text["grade"] = healthGradeName(taint.grade);
    }
    if (taint.acknowledgement) {
        text["acknowledged"] = {
            {"by", taint.acknowledgement->by}, {"when", taint.acknowledgement->when}, {"note", taint.acknowledgement->note}};
    }
    return text;
}

}  // namespace

std::string provenanceText(const RunReader& run) {
    return provenanceText(run.origin(), &run);
}

std::string provenanceText(const RunOrigin& origin, const RunReader* run) {
    nlohmann::json text = originJson(origin);
    text.erase("fe_path");
    text.erase("fe_sha256");
    text.erase("terrain_path");
    text.erase("terrain_sha256");
    text["inputs"] = {{{"role", "fe"}, {"path", origin.fePath}, {"sha256", origin.feSha256}}};
    if (!origin.terrainPath.empty()) {
        text["inputs"].push_back({{"role", "terrain"}, {"path", origin.terrainPath}, {"sha256", origin.terrainSha256}});
    }
    for (const RecordedInput& mesh : origin.surroundings) {
        text["inputs"].push_back({{"role", "surroundings"}, {"path", mesh.path}, {"sha256", mesh.sha256}});
        if (mesh.offset != Vec3::Zero()) {
            text["inputs"].back()["offset_m"] = {mesh.offset.x(), mesh.offset.y(), mesh.offset.z()};
        }
    }
    text["coordinates"] = std::string(SitePlace(origin.frame, origin.site).words());
    if (run != nullptr) {
        text["run_complete"] = run->complete();
        text["frames"] = run->frameCount();
        text["cautions"] = cautionsJson(runCautions(standingOf(*run)));
        if (const auto result = run->result()) {
            text["trajectory_hash"] = result->trajectoryHash.hex();
            text["health"] = healthText(*run);
        }
    }
    return jsonText(text);
}

std::string withCoordinates(const std::string& provenance, const std::string& words) {
    nlohmann::json document = nlohmann::json::parse(provenance);
    if (!document.contains("coordinates") || document["coordinates"] == words) {
        return provenance;
    }
    document["coordinates"] = words;
    return jsonText(document);
}

}  // namespace rubble::io
