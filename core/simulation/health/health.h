#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/hash.h"
#include "core/base/ids.h"
#include "core/base/message.h"

namespace rubble {

/// What the monitor watches.
enum class HealthCheck : std::uint8_t {
    Energy,       ///< gain beyond gravity, births, and the work of pieces, ties, water and other effects
    Penetration,  ///< sustained overlap of bodies
    Speed,        ///< faster than birth and fall allow
    BelowGround,  ///< centre below the ground
    OutsideSite,  ///< 10 building heights away, and ten times the drop of the terrain to there
    NotANumber,   ///< place or velocity is no number
    AsleepShare,  ///< falls after it had reached 95 %
    Bulking       ///< pile below 1.15 or above 2 times its material
};
inline constexpr std::size_t healthCheckCount = 8;
/// "energy", "penetration", "speed", "below_ground", "outside_site", "not_a_number", "asleep_share", "bulking".
std::string_view healthCheckName(HealthCheck check);
/// The check in a few words for people: "energy gained".
Message healthCheckTitle(HealthCheck check);

/// The limits (PHYSICS section 6). What lies on a limit is still sound.
struct HealthLimits {
    double energyGain = 0.001;       ///< of the work of gravity so far
    double penetration = 0.10;       ///< of the smaller body's smallest side
    double crowdPenetration = 0.05;  ///< of the same, where many bodies are that deep
    double crowd = 0.01;             ///< share of the bodies
    double sustained = 0.5;          ///< s, that a penetration must last to count
    double speed = 1.05;             ///< of sqrt(v_birth^2 + 2 g h)
    double siteHeights = 10.0;       ///< building heights beyond the structure; on a terrain also of its drop to there
    double bornBelowGrace = 1.0;     ///< s, in which a body born below ground may come up
    double asleep = 0.95;            ///< share of the bodies; it must not fall again once it has been reached
    double asleepSlack = 0.01;       ///< share that may wake all the same
    double bulkingLow = 1.15;        ///< below: the pile squeezes into itself
    double bulkingHigh = 2.0;        ///< above: its shapes are inflated
    double bulkingLayers = 2.0;      ///< fragments that the debris must lie deep on average to be a pile
    double interval = 0.5;           ///< s; breaches of one check no further apart than this are one
    double remedyTime = 0.5;         ///< s of smaller steps after an energy or penetration breach, with auto_remedy
};

/// What a passed limit means for whoever uses the run (passed_limits.h says which and why).
enum class HealthGrade : std::uint8_t {
    Notice,   ///< good to know; the debris is the same
    Finding,  ///< single bodies, or a little of the whole, are not as they should be
    Tainted   ///< figures of the debris should not be relied on until someone vouches for them
};

/// A limit that was passed, from when to when.
struct HealthBreach {
    HealthCheck check{};
    double from = 0.0;                                          ///< s
    double to = 0.0;                                            ///< s, the last instant at which it held
    double worstAt = std::numeric_limits<double>::quiet_NaN();  ///< s, when it was worst; NaN in a run that did not note it
    std::optional<BodyId> body;                                 ///< the worst one, where there is one
    Vec3 place = Vec3::Zero();                                  ///< m, local, of that body then
    double worst = 0.0;                                         ///< measured, in the unit of the limit; NaN where it was no number
    double limit = 0.0;
    std::int64_t bodies = 0;  ///< how many broke it then
    Message what;             ///< with numbers and units
    Message remedy;           ///< names the setting to change
};

/// Steps were halved, from when to when.
struct HealthRemedy {
    double from = 0.0;       ///< s
    double to = 0.0;         ///< s
    std::int64_t steps = 0;  ///< that were halved
};

/// What the monitor saw. A run with a breach of the grade Tainted is tainted until someone acknowledges its breaches.
struct HealthReport {
    std::vector<HealthBreach> breaches;  ///< in the order in which they began
    std::vector<HealthRemedy> remedies;  ///< by auto_remedy, in order
    double penetrationSustained = 0.0;   ///< m, deepest that lasted over 0.5 s
    double penetrationShare = 0.0;       ///< deepest that lasted over 0.5 s, of the smallest side of its body
    double crowdShare = 0.0;             ///< largest share of the bodies that was above 5 % for over 0.5 s
    double fastestOverLimit = 0.0;       ///< largest speed over sqrt(v_birth^2 + 2 g h); those a piece pushed excepted
    double farthest = 0.0;               ///< m, largest distance of a body from the structure
    double asleepPeak = 0.0;             ///< share
    std::int64_t contactsPeak = 0;       ///< touching pairs
    std::int64_t bodiesLost = 0;         ///< taken out because their place or velocity was no number
    /// A limit was passed so far that the figures of the debris should not be relied on.
    bool tainted() const;
};

}  // namespace rubble
