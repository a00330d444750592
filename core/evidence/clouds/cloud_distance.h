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

/// A site as the scan of a cloud would have seen it, ray by ray.
struct SeenSite {
    /// @param points  of the cloud, in the order of orderByCubes() with this radius; @param met  where the ray of each meets the
    /// site, not a number: nowhere; @param radius  how far from its point a ray may meet the site for both to be a pair
    SeenSite(const std::vector<Vec3>& points, std::vector<Vec3> met, double radius);

    std::vector<Eigen::Vector3f> moves;  ///< [points] from each to the other of its pair; NaN: it has none
    PointIndex others;                   ///< what rays met farther off
};

/// The distance from the first cloud to the second at a core point.
struct CoreDistance {
    CoreState state = CoreState::NoNormal;
    Vec3 normal = Vec3::Zero();  ///< of length 1, upwards; NaN without one
    CoreSide first;
    CoreSide second;
    std::uint32_t pairs = 0;  ///< points of both sides that one ray met; 0 between two clouds
    double distance = 0.0;    ///< along the normal, above zero where the second cloud lies above; NaN unless measured
    double error = 0.0;       ///< standard error, without that of the registration; NaN with fewer than four points on either side
    /// Level of detection at 95 %: so many times the error, and 1.96 times the registration error, one added to the other. NaN
    /// without an error. Without a registration error it holds the roughness alone.
    double detection = 0.0;

    bool significant() const { return distance > detection || distance < -detection; }
};

/// Fewest points of a cloud that tell its roughness.
inline constexpr std::uint32_t roughnessPoints = 4;

/// Measures at every core between two clouds. Their points count as two samples, and the level of detection takes 1.96 times the
/// error of both means, with the deviation of all points (Lague et al. 2013, equation 1), as CloudCompare and PDAL do.
/// No result depends on the number of threads. Throws Cancelled.
std::vector<CoreDistance> cloudDistances(const std::vector<Vec3>& cores, const PointIndex& first, const PointIndex& second,
                                         const CloudDistanceSettings& settings, const Execution& execution);

/// Measures at every core from a cloud to a site. A point in the cylinder counts with what its own ray meets, if that is near;
/// what rays met farther off counts where it lies in the cylinder. Both see one surface by the same rays, so the shape of that
/// surface is in both means and no error of their difference: the two samples overlap in part (Derrick, Russ, Toher & White 2017,
/// J. Mod. Appl. Stat. Methods 16(1), T_new2). That is the paired test where all points have a pair, Welch's where none has. The
/// level of detection takes Student's number for its degrees of freedom, so that few points keep 95 %.
/// No result depends on the number of threads. Throws Cancelled.
std::vector<CoreDistance> siteDistances(const std::vector<Vec3>& cores, const PointIndex& first, const SeenSite& second,
                                        const CloudDistanceSettings& settings, const Execution& execution);

/// The middle one of all levels of detection; NaN: there is none.
double middleDetection(const std::vector<CoreDistance>& cores);

}  // namespace rubble
