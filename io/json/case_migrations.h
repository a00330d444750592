#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace rubble::io {

/// Turns a case document of version `from` into one of version from + 1.
struct CaseMigration {
    int from;
    void (*step)(nlohmann::json&);
};

inline constexpr int caseVersion = 5;

/// The known steps, one for each older version, oldest first.
std::span<const CaseMigration> caseMigrations();

/// Brings the scenario of a run up to date. A run bears no case version: what stands there tells which steps it needs.
void migrateScenario(nlohmann::json& scenario);

/// Brings a document from version `from` to version `to`, one step at a time, and writes the new version into it.
/// @return false if a step between the two is missing
bool migrateCase(nlohmann::json& document, int from, int to, std::span<const CaseMigration> steps);

}  // namespace rubble::io
