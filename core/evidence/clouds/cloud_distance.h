#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/clouds/point_index.h"

namespace rubble {

/// How distances between two clouds are measured, by M3C2 (Lague, Brodu & Leroux 2013). Lengths are in units of the places.
struct CloudDistanceSettings {
    double normalRadius = 0.0;      ///< about a core: points of the first cloud here give the normal
    double projectionRadius = 0.0;  ///< of the cylinder along the normal in which both clouds are averaged
    double depth = 0.0;             ///< of the cylinder, to each side of the core
    /// By which one cloud may be out of place against the other; unset: nobody stated it.
    std::optional<double> registrationError;
    bool upwards = false;  ///< straight up is taken for the normal everywhere
};

/// Why a core has no distance.
enum class CoreState : std::uint8_t {
    Measured,
    NoNormal,  ///< fewer than three points of the first cloud about it, or all on a line
    NoFirst,   ///< no point of the first cloud in the cylinder
    NoSecond,  ///< none of the second
    NoPoint,   ///< none of either
};
inline constexpr std::size_t coreStateCount = 5;

/// Points of a cloud in the cylinder of a core.
struct CoreSide {
    std::uint32_t points = 0;
    double mean = 0.0;       ///< along the normal from the core; NaN without points
    double roughness = 0.0;  ///< standard deviation along the normal, of all points there; NaN without points
};

/// The distance from the first cloud to the second at a core point.
struct CoreDistance {
    CoreState state = CoreState::NoNormal;
    Vec3 normal = Vec3::Zero();  ///< of length 1, upwards; NaN without one
    CoreSide first;
    CoreSide second;
    double distance = 0.0;  ///< along the normal, above zero where the second cloud lies above; NaN unless measured
    /// Level of detection at 95 %: 1.96 times the error of the means and the registration error, one added to the other. NaN with
    /// fewer than four points on either side. Without a registration error it holds the roughness alone.
    double detection = 0.0;

    bool significant() const { return distance > detection || distance < -detection; }
};

/// Fewest points of a cloud that tell its roughness.
inline constexpr std::uint32_t roughnessPoints = 4;

/// Measures at every core. No result depends on the number of threads. Throws Cancelled.
std::vector<CoreDistance> cloudDistances(const std::vector<Vec3>& cores, const PointIndex& first, const PointIndex& second,
                                         const CloudDistanceSettings& settings, const Execution& execution);

}  // namespace rubble
