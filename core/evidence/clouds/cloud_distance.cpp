#include "core/evidence/clouds/cloud_distance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/unknown.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

namespace {

constexpr std::size_t coresAtOnce = 64;
constexpr double confidence95 = 1.96;

/// The sum of numbers in whatever order they come, for it is one of whole numbers: parts of the greatest of them, so small that
/// only their sum fills 62 bits. That costs less than to put them into order.
double sumOf(const std::vector<double>& numbers) {
    double greatest = 0.0;
    for (const double number : numbers) {
        greatest = std::max(greatest, std::abs(number));
    }
    if (greatest == 0.0) {
        return 0.0;
    }
    const int bits = 61 - std::bit_width(numbers.size()) - std::ilogb(greatest);
    const double scale = std::ldexp(1.0, std::min(bits, 1000));
    std::int64_t sum = 0;
    for (const double number : numbers) {
        sum += static_cast<std::int64_t>(number * scale);
    }
    return static_cast<double>(sum) / scale;
}

/// Measures at one core after the other.
class CoreMeasuring {
public:
    CoreMeasuring(const PointIndex& first, const PointIndex& second, const CloudDistanceSettings& settings)
        : m_first(first), m_second(second), m_settings(settings) {}

    CoreDistance at(const Vec3& core) {
        CoreDistance made;
        made.distance = made.detection = unknown;
        made.normal = normalAt(core);
        made.first.mean = made.first.roughness = made.second.mean = made.second.roughness = unknown;
        if (!made.normal.allFinite()) {
            return made;
        }
        made.first = sideOf(m_first, core, made.normal);
        made.second = sideOf(m_second, core, made.normal);
        if (made.first.points == 0 || made.second.points == 0) {
            const bool both = made.first.points == made.second.points;
            made.state = both ? CoreState::NoPoint : (made.first.points == 0 ? CoreState::NoFirst : CoreState::NoSecond);
            return made;
        }
        made.state = CoreState::Measured;
        made.distance = made.second.mean - made.first.mean;
        if (std::min(made.first.points, made.second.points) >= roughnessPoints) {
            const double ofMeans = std::sqrt(made.first.roughness * made.first.roughness / made.first.points +
                                             made.second.roughness * made.second.roughness / made.second.points);
            made.detection = confidence95 * (ofMeans + m_settings.registrationError.value_or(0.0));
        }
        return made;
    }

private:
    /// Of the plane through the points of the first cloud about the core, upwards; NaN where they give none.
    Vec3 normalAt(const Vec3& core) {
        if (m_settings.upwards) {
            return Vec3::UnitZ();
        }
        const Vec3 none = Vec3::Constant(unknown);
        const BallMoments moments = m_first.moments(core, m_settings.normalRadius);
        if (moments.points < 3) {
            return none;
        }
        const Eigen::SelfAdjointEigenSolver<Mat3> axes(moments.spread);
        // Points on a line have planes all around it.
        constexpr double least = 1e-12;
        if (axes.info() != Eigen::Success || !(axes.eigenvalues()[1] > least * axes.eigenvalues()[2])) {
            return none;
        }
        Vec3 normal = axes.eigenvectors().col(0);
        const bool downwards =
            normal.z() < 0.0 || (normal.z() == 0.0 && (normal.x() < 0.0 || (normal.x() == 0.0 && normal.y() < 0.0)));
        if (downwards) {
            normal = -normal;
        }
        return normal;
    }

    CoreSide sideOf(const PointIndex& cloud, const Vec3& core, const Vec3& normal) {
        cloud.withinCylinder(core, normal, m_settings.projectionRadius, m_settings.depth, m_offsets);
        CoreSide side;
        side.points = static_cast<std::uint32_t>(m_offsets.size());
        const auto count = static_cast<double>(m_offsets.size());
        side.mean = m_offsets.empty() ? unknown : sumOf(m_offsets) / count;
        for (double& offset : m_offsets) {
            offset = (offset - side.mean) * (offset - side.mean);
        }
        side.roughness = m_offsets.empty() ? unknown : std::sqrt(sumOf(m_offsets) / count);
        return side;
    }

    const PointIndex& m_first;
    const PointIndex& m_second;
    const CloudDistanceSettings& m_settings;
    std::vector<double> m_offsets;  ///< m, along the normal
};

}  // namespace

std::vector<CoreDistance> cloudDistances(const std::vector<Vec3>& cores, const PointIndex& first, const PointIndex& second,
                                         const CloudDistanceSettings& settings, const Execution& execution) {
    std::vector<CoreDistance> made(cores.size());
    WorkerPool pool(execution.threads());
    pool.loop(cores.size(), coresAtOnce, [&](std::size_t from, std::size_t to) {
        CoreMeasuring measuring(first, second, settings);
        for (std::size_t k = from; k < to && !execution.cancelled(); ++k) {
            made[k] = measuring.at(cores[k]);
        }
    });
    execution.check();
    return made;
}

}  // namespace rubble
