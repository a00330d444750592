#include "io/case_migrations.h"

#include <algorithm>

namespace rubble::io {

std::span<const CaseMigration> caseMigrations() {
    // Version 1 is the first; a change of the format adds its step here.
    return {};
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
