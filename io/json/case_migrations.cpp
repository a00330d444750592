#include "io/json/case_migrations.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json/ensemble_json.h"

namespace rubble::io {

namespace {

/// The ground was a switch; it became an effect that is off, on or auto. What is not as it should be is left for the reader to
/// name.
void groundBecomesAnEffect(nlohmann::json& scenario) {
    if (!scenario.is_object() || !scenario.contains("settings") || !scenario["settings"].is_object()) {
        return;
    }
    nlohmann::json& settings = scenario["settings"];
    if (const auto ground = settings.find("ground"); ground != settings.end() && ground->is_boolean()) {
        *ground = ground->get<bool>() ? "on" : "off";
    }
}

void fromVersionOne(nlohmann::json& document) {
    const auto scenarios = document.find("scenarios");
    if (scenarios != document.end() && scenarios->is_array()) {
        std::for_each(scenarios->begin(), scenarios->end(), groundBecomesAnEffect);
    }
}

/// Cases had no bookmarks, and of photographs only the files.
void fromVersionTwo(nlohmann::json& document) {
    document.emplace("bookmarks", nlohmann::json::array());
    document.emplace("photographs", nlohmann::json::array());
}

/// Nothing was written of how a case came to be.
void fromVersionThree(nlohmann::json& document) {
    document.emplace("journal", nlohmann::json::array());
}

/// Cases had no ensemble.
void fromVersionFour(nlohmann::json& document) {
    document.emplace("ensemble", ensembleJson(EnsembleSettings{usualVariations()}));
}

}  // namespace

std::span<const CaseMigration> caseMigrations() {
    static constexpr CaseMigration steps[] = {
        {1, fromVersionOne}, {2, fromVersionTwo}, {3, fromVersionThree}, {4, fromVersionFour}};
    return steps;
}

void migrateScenario(nlohmann::json& scenario) {
    groundBecomesAnEffect(scenario);
}

bool migrateCase(nlohmann::json& document, int from, int to, std::span<const CaseMigration> steps) {
    for (int version = from; version < to; ++version) {
        const auto known =
            std::find_if(steps.begin(), steps.end(), [version](const CaseMigration& m) { return m.from == version; });
        if (known == steps.end()) {
            return false;
        }
        known->step(document);
        document["version"] = version + 1;
    }
    return true;
}

}  // namespace rubble::io
