#include "core/evidence/clouds/cloud_distance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/analysis/accuracy/interval_fit.h"
#include "core/base/memory.h"
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

double meanOf(const std::vector<double>& numbers) {
    return sumOf(numbers) / static_cast<double>(numbers.size());
}

/// The sum of the products of what two lists are off their means.
double productsOf(const std::vector<double>& one, const std::vector<double>& other, std::vector<double>& room) {
    const double meanOfOne = meanOf(one);
    const double meanOfOther = &one == &other ? meanOfOne : meanOf(other);
    room.resize(one.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        room[k] = (one[k] - meanOfOne) * (other[k] - meanOfOther);
    }
    return sumOf(room);
}

/// Measures at one core after the other.
class CoreMeasuring {
public:
    CoreMeasuring(const PointIndex& first, const CloudDistanceSettings& settings) : m_first(first), m_settings(settings) {}
    CoreMeasuring(const CoreMeasuring&) = delete;
    CoreMeasuring& operator=(const CoreMeasuring&) = delete;
    virtual ~CoreMeasuring() = default;

    CoreDistance at(const Vec3& core) {
        CoreDistance made;
        made.distance = made.error = made.detection = unknown;
        made.normal = normalAt(core);
        made.first.mean = made.first.roughness = made.second.mean = made.second.roughness = unknown;
        if (!made.normal.allFinite()) {
            return made;
        }
        takeSides(core, made.normal);
        made.first = sideOf(m_ofFirst);
        made.second = sideOf(m_ofSecond);
        if (made.first.points == 0 || made.second.points == 0) {
            const bool both = made.first.points == made.second.points;
            made.state = both ? CoreState::NoPoint : (made.first.points == 0 ? CoreState::NoFirst : CoreState::NoSecond);
            return made;
        }
        made.state = CoreState::Measured;
        made.distance = made.second.mean - made.first.mean;
        if (std::min(made.first.points, made.second.points) >= roughnessPoints) {
            const double times = judge(made);
            made.detection = times * made.error + confidence95 * m_settings.registrationError.value_or(0.0);
        }
        return made;
    }

protected:
    /// Takes the points of both sides, along the normal.
    virtual void takeSides(const Vec3& core, const Vec3& normal) = 0;
    /// Tells the error of a distance. @return  so many times the error hold 95 %
    virtual double judge(CoreDistance& made) = 0;

    const PointIndex& m_first;
    const CloudDistanceSettings& m_settings;
    std::vector<double> m_ofFirst;  ///< m, along the normal
    std::vector<double> m_ofSecond;
    std::vector<double> m_room;

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

    CoreSide sideOf(const std::vector<double>& offsets) {
        CoreSide side;
        side.points = static_cast<std::uint32_t>(offsets.size());
        side.mean = offsets.empty() ? unknown : meanOf(offsets);
        side.roughness = offsets.empty() ? unknown : std::sqrt(productsOf(offsets, offsets, m_room) / side.points);
        return side;
    }
};

class CloudAndCloud : public CoreMeasuring {
public:
    CloudAndCloud(const PointIndex& first, const PointIndex& second, const CloudDistanceSettings& settings)
        : CoreMeasuring(first, settings), m_second(second) {}

private:
    void takeSides(const Vec3& core, const Vec3& normal) override {
        m_first.withinCylinder(core, normal, m_settings.projectionRadius, m_settings.depth, m_ofFirst);
        m_second.withinCylinder(core, normal, m_settings.projectionRadius, m_settings.depth, m_ofSecond);
    }

    double judge(CoreDistance& made) override {
        made.error = std::sqrt(made.first.roughness * made.first.roughness / made.first.points +
                               made.second.roughness * made.second.roughness / made.second.points);
        return confidence95;
    }

    const PointIndex& m_second;
};

class CloudAndSite : public CoreMeasuring {
public:
    CloudAndSite(const PointIndex& first, const SeenSite& second, const CloudDistanceSettings& settings)
        : CoreMeasuring(first, settings), m_second(second) {}

private:
    void takeSides(const Vec3& core, const Vec3& normal) override {
        m_first.withinCylinder(core, normal, m_settings.projectionRadius, m_settings.depth, m_ofFirst, &m_numbers);
        m_pairedFirst.clear();
        m_pairedSecond.clear();
        for (std::size_t k = 0; k < m_numbers.size(); ++k) {
            const double move = normal.dot(m_second.moves[m_numbers[k]].cast<double>());
            if (!std::isnan(move)) {
                m_pairedFirst.push_back(m_ofFirst[k]);
                m_pairedSecond.push_back(m_ofFirst[k] + move);
            }
        }
        m_second.others.withinCylinder(core, normal, m_settings.projectionRadius, m_settings.depth, m_ofSecond);
        m_ofSecond.insert(m_ofSecond.end(), m_pairedSecond.begin(), m_pairedSecond.end());
    }

    /// Of what both sides of the pairs have in common.
    double correlation() {
        if (m_pairedFirst.size() < 2) {
            return 0.0;
        }
        const double ofFirst = productsOf(m_pairedFirst, m_pairedFirst, m_room);
        const double ofSecond = productsOf(m_pairedSecond, m_pairedSecond, m_room);
        const double root = std::sqrt(ofFirst * ofSecond);
        return root > 0.0 ? productsOf(m_pairedFirst, m_pairedSecond, m_room) / root : 0.0;
    }

    double judge(CoreDistance& made) override {
        made.pairs = static_cast<std::uint32_t>(m_pairedFirst.size());
        const double pairs = made.pairs;
        const double first = made.first.points;
        const double second = made.second.points;
        // Variances of both means, with the deviation of a sample.
        const double ofFirst = made.first.roughness * made.first.roughness / (first - 1.0);
        const double ofSecond = made.second.roughness * made.second.roughness / (second - 1.0);
        const double shared = 2.0 * correlation() * pairs * std::sqrt(ofFirst * ofSecond / (first * second));
        made.error = std::sqrt(std::max(0.0, ofFirst + ofSecond - shared));
        const double both = ofFirst + ofSecond;
        const double welch =
            both > 0.0 ? both * both / (ofFirst * ofFirst / (first - 1.0) + ofSecond * ofSecond / (second - 1.0)) : first + second;
        const double alone = first + second - 2.0 * pairs;
        const double degrees = pairs - 1.0 + (welch - pairs + 1.0) * alone / (first + second);
        return studentQuantile(confidence95, std::max(1.0, degrees));
    }

    const SeenSite& m_second;
    std::vector<std::uint32_t> m_numbers;
    std::vector<double> m_pairedFirst;
    std::vector<double> m_pairedSecond;
};

template <class Measuring, class Second>
std::vector<CoreDistance> measured(const std::vector<Vec3>& cores, const PointIndex& first, const Second& second,
                                   const CloudDistanceSettings& settings, const Execution& execution) {
    std::vector<CoreDistance> made(cores.size());
    WorkerPool pool(execution.threads());
    pool.loop(cores.size(), coresAtOnce, [&](std::size_t from, std::size_t to) {
        Measuring measuring(first, second, settings);
        for (std::size_t k = from; k < to && !execution.cancelled(); ++k) {
            made[k] = measuring.at(cores[k]);
        }
    });
    execution.check();
    return made;
}

/// The move from each point to what its ray met, if that is near; the others go into a list.
std::vector<Eigen::Vector3f> movesTo(const std::vector<Vec3>& points, std::vector<Vec3>& met, double radius) {
    std::vector<Eigen::Vector3f> moves;
    reserveLarge(moves, points.size());
    std::size_t others = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 move = met[k] - points[k];
        const bool near = move.squaredNorm() <= radius * radius;
        moves.emplace_back(near ? Eigen::Vector3f(move.cast<float>()) : Eigen::Vector3f::Constant(static_cast<float>(unknown)));
        if (!near && met[k].allFinite()) {
            met[others++] = met[k];
        }
    }
    met.resize(others);
    met.shrink_to_fit();
    return moves;
}

}  // namespace

SeenSite::SeenSite(const std::vector<Vec3>& points, std::vector<Vec3> met, double radius)
    : moves(movesTo(points, met, radius)), others(std::move(met), radius) {}

std::vector<CoreDistance> cloudDistances(const std::vector<Vec3>& cores, const PointIndex& first, const PointIndex& second,
                                         const CloudDistanceSettings& settings, const Execution& execution) {
    return measured<CloudAndCloud>(cores, first, second, settings, execution);
}

std::vector<CoreDistance> siteDistances(const std::vector<Vec3>& cores, const PointIndex& first, const SeenSite& second,
                                        const CloudDistanceSettings& settings, const Execution& execution) {
    return measured<CloudAndSite>(cores, first, second, settings, execution);
}

double middleDetection(const std::vector<CoreDistance>& cores) {
    std::vector<double> levels;
    for (const CoreDistance& core : cores) {
        if (std::isfinite(core.detection)) {
            levels.push_back(core.detection);
        }
    }
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::nth_element(levels.begin(), middle, levels.end());
    return levels.empty() ? unknown : *middle;
}

}  // namespace rubble
