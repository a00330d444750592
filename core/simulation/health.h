#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/message.h"

namespace rubble {

/// What the monitor watches (limits: PHYSICS section 6).
enum class HealthCheck : std::uint8_t {
    Energy,       ///< gain beyond gravity, births, and the work of pieces, ties and water
    Penetration,  ///< sustained overlap of bodies
    Speed,        ///< faster than birth and fall allow
    BelowGround,  ///< centre below the ground
    OutsideSite,  ///< 10 building heights away
    NotANumber,   ///< place or velocity is no number
    AsleepShare,  ///< falls after it had reached 95 %
    Bulking       ///< pile below 1.15 or above 2 times its material
};
inline constexpr std::size_t healthCheckCount = 8;
/// "energy", "penetration", ...
std::string_view healthCheckName(HealthCheck check);

/// A limit that was passed, from when to when.
struct HealthBreach {
    HealthCheck check{};
    double from = 0.0;           ///< s
    double to = 0.0;             ///< s, the last instant at which it held
    std::optional<BodyId> body;  ///< the worst one, where it is about bodies
    Vec3 place = Vec3::Zero();   ///< m, local, of that body at the worst instant
    double worst = 0.0;          ///< measured, in the unit of the limit
    double limit = 0.0;
    std::int64_t bodies = 0;  ///< how many broke it at the worst instant
    Message what;             ///< with numbers and units
    Message remedy;
};

/// What the monitor saw. A run with breaches is tainted until someone acknowledges them.
struct HealthReport {
    std::vector<HealthBreach> breaches;  ///< in the order in which they began
    double penetrationSustained = 0.0;   ///< m, deepest that lasted over 0.5 s
    std::int64_t contactsPeak = 0;       ///< touching pairs
    double asleepPeak = 0.0;             ///< share
    double fastestOverLimit = 0.0;       ///< largest speed over sqrt(v_birth^2 + 2 g h)
    bool tainted() const { return !breaches.empty(); }
};

}  // namespace rubble
