#include "io/json/ensemble_json.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace rubble::io {

nlohmann::json ensembleJson(const EnsembleSettings& settings) {
    nlohmann::json varied = nlohmann::json::array();
    for (const VariedSetting& each : settings.varied) {
        varied.push_back({{"key", each.key}, {"distribution", variationText(each)}});
    }
    return {{"members", settings.members}, {"seed", settings.seed}, {"varied", std::move(varied)}};
}

EnsembleSettings ensembleFromJson(const JsonCursor& cursor) {
    cursor.allowOnly({"members", "seed", "varied"});
    EnsembleSettings settings;
    settings.members = cursor["members"].integer();
    settings.seed = cursor["seed"].integer();
    for (const JsonCursor& each : cursor["varied"].elements()) {
        each.allowOnly({"key", "distribution"});
        try {
            settings.varied.push_back(variationFrom(each["key"].text(), each["distribution"].text()));
        } catch (const UsageError& error) {
            each.refuse(error.what(), englishText(error.remedy()));
        }
    }
    try {
        checkEnsemble(settings);
    } catch (const UsageError& error) {
        cursor.refuse(error.what(), englishText(error.remedy()));
    }
    return settings;
}

}  // namespace rubble::io
