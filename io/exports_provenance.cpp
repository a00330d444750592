#include "io/exports.h"
#include "io/run_json.h"

namespace rubble::io {

std::string provenanceText(const RunReader& run) {
    const RunOrigin& origin = run.origin();
    nlohmann::json text = originJson(origin);
    text.erase("fe_path");
    text.erase("fe_sha256");
    text["inputs"] = {{{"role", "fe"}, {"path", origin.fePath}, {"sha256", origin.feSha256}}};
    text["coordinates"] = "metres, z up, origin of the frame added";
    text["run_complete"] = run.complete();
    text["frames"] = run.frameCount();
    if (const auto result = run.result()) {
        text["trajectory_hash"] = result->trajectoryHash.hex();
    }
    return jsonText(text);
}

}  // namespace rubble::io
