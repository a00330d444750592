#include "io/exports.h"
#include "io/run_json.h"

namespace rubble::io {

std::string provenanceText(const RunReader& run) {
    const RunOrigin& origin = run.origin();
    nlohmann::json text = originJson(origin);
    text.erase("fe_path");
    text.erase("fe_sha256");
    text.erase("terrain_path");
    text.erase("terrain_sha256");
    text["inputs"] = {{{"role", "fe"}, {"path", origin.fePath}, {"sha256", origin.feSha256}}};
    if (!origin.terrainPath.empty()) {
        text["inputs"].push_back({{"role", "terrain"}, {"path", origin.terrainPath}, {"sha256", origin.terrainSha256}});
    }
    text["coordinates"] = "metres, z up, origin of the frame added";
    text["run_complete"] = run.complete();
    text["frames"] = run.frameCount();
    if (const auto result = run.result()) {
        text["trajectory_hash"] = result->trajectoryHash.hex();
    }
    return jsonText(text);
}

}  // namespace rubble::io
