#include "core/simulation/health/health.h"

#include <array>

#include "core/simulation/health/passed_limits.h"

namespace rubble {

namespace {

struct CheckRow {
    std::string_view name;
    const char* titleId;
    const char* title;
};

constexpr std::array<CheckRow, healthCheckCount> rows{{{"energy", "health.energy.title", "energy gained"},
                                                       {"penetration", "health.penetration.title", "bodies inside each other"},
                                                       {"speed", "health.speed.title", "faster than gravity"},
                                                       {"below_ground", "health.below_ground.title", "below the ground"},
                                                       {"outside_site", "health.outside_site.title", "far outside the site"},
                                                       {"not_a_number", "health.not_a_number.title", "not a number"},
                                                       {"asleep_share", "health.asleep_share.title", "a pile at rest wakes"},
                                                       {"bulking", "health.bulking.title", "volume of the pile"}}};

}  // namespace

bool HealthReport::tainted() const {
    return gravestGrade(breaches) == HealthGrade::Tainted;
}

std::string_view healthCheckName(HealthCheck check) {
    return rows[static_cast<std::size_t>(check)].name;
}

Message healthCheckTitle(HealthCheck check) {
    const CheckRow& row = rows[static_cast<std::size_t>(check)];
    return {row.titleId, row.title, {}};
}

}  // namespace rubble
