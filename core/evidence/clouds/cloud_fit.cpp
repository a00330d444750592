#include "core/evidence/clouds/cloud_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Ways = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t fittedMost = 200'000;
constexpr std::size_t pairsLeast = 50;
constexpr std::size_t planePoints = 5;
/// Of the least to the greatest eigenvalue: below it a direction or a turn is open.
constexpr double openShare = 1e-5;
/// Radii along a side of a patch, over whose points noise averages out.
constexpr double patchRadii = 8.0;
constexpr std::size_t patchPairs = 8;

/// A point of the second cloud, where it lies now, and the plane of the first cloud about it.
struct PlanePair {
    Vec3 place = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double off = unknown;  ///< along the normal from the point to the plane; not a number without a plane
};

PlanePair pairOf(const PointIndex& first, const Vec3& place, double radius, std::vector<Vec3>& found) {
    PlanePair pair;
    pair.place = place;
    first.within(place, radius, found);
    if (found.size() < planePoints) {
        return pair;
    }
    Vec3 mean = Vec3::Zero();
    for (const Vec3& there : found) {
        mean += there - place;
    }
    mean /= static_cast<double>(found.size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& there : found) {
        const Vec3 from = there - place - mean;
        spread += from * from.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    // Corners and edges have no plane.
    if (axes.info() != Eigen::Success || !(axes.eigenvalues()[1] > 4.0 * axes.eigenvalues()[0])) {
        return pair;
    }
    pair.normal = axes.eigenvectors().col(0);
    pair.off = pair.normal.dot(mean);
    return pair;
}

double middleOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class CloudFitting {
public:
    CloudFitting(const PointIndex& first, const std::vector<Vec3>& second, const CloudFitSettings& settings,
                 const Execution& execution)
        : m_first(first), m_settings(settings), m_execution(execution) {
        m_fit.cube = settings.radius;
        m_points = thinned(second, m_fit.cube);
        // Points lie on surfaces, so their number falls with the square of the side; a little more ends it in few rounds.
        while (m_points.size() > fittedMost) {
            m_fit.cube *= 1.05 * std::sqrt(static_cast<double>(m_points.size()) / static_cast<double>(fittedMost));
            m_points = thinned(m_points, m_fit.cube);
        }
        for (const Vec3& place : m_points) {
            m_fit.about += place;
        }
        m_fit.about /= static_cast<double>(std::max<std::size_t>(1, m_points.size()));
    }

    CloudFit fit() {
        pair();
        m_fit.before = rootMeanSquare();
        while (m_fit.rounds < m_settings.rounds && !m_fit.settled) {
            step();
            pair();
            ++m_fit.rounds;
        }
        m_fit.after = rootMeanSquare();
        judge();
        return m_fit;
    }

private:
    static std::vector<Vec3> thinned(const std::vector<Vec3>& places, double cube) {
        std::vector<Vec3> taken;
        CubeThinning thinning(cube);
        std::copy_if(places.begin(), places.end(), std::back_inserter(taken),
                     [&](const Vec3& place) { return thinning.takes(place); });
        return taken;
    }

    void pair() {
        m_pairs.resize(m_points.size());
        WorkerPool pool(m_execution.threads());
        pool.loop(m_points.size(), 256, [&](std::size_t from, std::size_t to) {
            std::vector<Vec3> found;
            for (std::size_t k = from; k < to && !m_execution.cancelled(); ++k) {
                m_pairs[k] = pairOf(m_first, m_fit(m_points[k]), m_settings.radius, found);
            }
        });
        m_execution.check();
        std::erase_if(m_pairs, [](const PlanePair& pair) { return std::isnan(pair.off); });
        if (m_pairs.size() < pairsLeast) {
            throw UsageError({"fit.few",
                              "Only {0} points of what did not move lie on a surface of the other cloud; a fit takes {1}",
                              {m_pairs.size(), pairsLeast}},
                             {"fit.few.remedy", "Give a larger area that did not move, or a greater radius.", {}});
        }
        m_fit.pairs = static_cast<std::int64_t>(m_pairs.size());
        std::vector<double> sizes(m_pairs.size());
        std::transform(m_pairs.begin(), m_pairs.end(), sizes.begin(), [](const PlanePair& each) { return std::abs(each.off); });
        m_scatter = 1.4826 * middleOf(sizes);
        const auto kept = static_cast<std::ptrdiff_t>(m_settings.kept * static_cast<double>(sizes.size()));
        std::nth_element(sizes.begin(), sizes.begin() + kept - 1, sizes.end());
        trim(sizes[static_cast<std::size_t>(kept - 1)]);
    }

    static std::size_t directionOf(const PlanePair& pair) {
        Eigen::Index axis = 0;
        pair.normal.cwiseAbs().maxCoeff(&axis);
        return static_cast<std::size_t>(axis);
    }

    /// Takes out what lies farther off than most pairs. Before the fit all of a few walls may lie farther off than the ground: the
    /// nearer half of the surfaces that look one way always counts, or nothing would bring them in.
    void trim(double most) {
        std::array<std::vector<double>, 3> sizes;
        for (const PlanePair& each : m_pairs) {
            sizes[directionOf(each)].push_back(std::abs(each.off));
        }
        std::array<double, 3> limits{most, most, most};
        for (std::size_t axis = 0; axis < limits.size(); ++axis) {
            if (sizes[axis].size() >= pairsLeast) {
                limits[axis] = std::max(most, middleOf(std::move(sizes[axis])));
            }
        }
        std::erase_if(m_pairs, [&](const PlanePair& each) { return std::abs(each.off) > limits[directionOf(each)]; });
    }

    double rootMeanSquare() const {
        double squares = 0.0;
        for (const PlanePair& each : m_pairs) {
            squares += each.off * each.off;
        }
        return std::sqrt(squares / static_cast<double>(m_pairs.size()));
    }

    Vec6 rowOf(const PlanePair& each) const {
        Vec6 row;
        row << (each.place - m_fit.about - m_fit.shift).cross(each.normal) / m_lever, each.normal;
        return row;
    }

    /// Turns are taken as lengths at a lever of the size of the cloud, so that they weigh as shifts do.
    void gather(Mat6& normal, Vec6& right) {
        double squares = 0.0;
        for (const PlanePair& each : m_pairs) {
            squares += (each.place - m_fit.about - m_fit.shift).squaredNorm();
        }
        m_lever = std::max(1e-9, std::sqrt(squares / static_cast<double>(m_pairs.size())));
        normal.setZero();
        right.setZero();
        for (const PlanePair& each : m_pairs) {
            const Vec6 row = rowOf(each);
            normal += row * row.transpose();
            right += row * each.off;
        }
        const Eigen::SelfAdjointEigenSolver<Mat6> axes(normal);
        const bool sound = axes.info() == Eigen::Success && axes.eigenvalues().allFinite();
        const auto held = (axes.eigenvalues().array() > openShare * axes.eigenvalues()[5]);
        const Eigen::Index open = sound ? 6 - held.count() : 6;
        if (open == 1) {
            refuseOpen(axes.eigenvectors().col(0));
        }
        if (open > 1) {
            refuseMoreOpen(sound ? Ways(axes.eigenvectors().leftCols(open)) : Ways(Mat6::Identity()));
        }
    }

    /// @param ways  shifts and turns that the surfaces tell nothing of, an orthonormal base of them
    [[noreturn]] static void refuseMoreOpen(const Ways& ways) {
        constexpr double mostly = 0.9;
        const auto isOpen = [&](Eigen::Index way) { return ways.row(way).norm() > mostly; };
        const Message more{"fit.open_more.remedy", "Take in surfaces that look other ways, such as walls, kerbs and slopes.", {}};
        if (ways.cols() == 3 && isOpen(2) && isOpen(3) && isOpen(4)) {
            throw UsageError(
                {"fit.open_level",
                 "What did not move is level: it holds the height of the cloud, not its place in plan or its turn about an "
                 "upright axis",
                 {}},
                more);
        }
        throw UsageError({"fit.open_more",
                          "What did not move leaves {0} of the six ways to shift and turn open: its surfaces look too much alike",
                          {static_cast<std::int64_t>(ways.cols())}},
                         more);
    }

    /// @param way  the shift and turn that the surfaces tell least of
    [[noreturn]] static void refuseOpen(const Vec6& way) {
        const Vec3 shift = way.tail<3>();
        const Vec3 turn = way.head<3>();
        const bool shifts = shift.norm() >= turn.norm();
        const Vec3 axis = (shifts ? shift : turn).normalized();
        const bool upright = std::abs(axis.z()) > std::numbers::sqrt2 / 2.0;
        // A line has two ends: the one on the side of x.
        const double east = std::atan2(axis.x(), axis.y()) * 180.0 / std::numbers::pi;
        const double bearing = std::round(east < 0.0 ? east + 180.0 : east);
        const Message more{"fit.open.remedy",
                           shifts ? "Take in surfaces that look that way: walls or kerbs across it, or ground for up and down."
                                  : "Take in surfaces far from that axis that look another way, such as walls, kerbs and slopes.",
                           {}};
        if (shifts && upright) {
            throw UsageError(
                {"fit.open_up", "What did not move leaves it open how high the cloud lies: its surfaces are upright", {}}, more);
        }
        if (shifts) {
            throw UsageError(
                {"fit.open_shift",
                 "What did not move leaves a shift along the bearing of {0}° (from the y axis towards x) open: no surface looks "
                 "that way",
                 {bearing}},
                more);
        }
        if (upright) {
            throw UsageError({"fit.open_turn_up", "What did not move leaves a turn about an upright axis open", {}}, more);
        }
        throw UsageError(
            {"fit.open_turn",
             "What did not move leaves a turn about a level axis along the bearing of {0}° (from the y axis towards x) open",
             {bearing}},
            more);
    }

    void step() {
        Mat6 normal;
        Vec6 right;
        gather(normal, right);
        const Vec6 move = normal.ldlt().solve(right);
        const Vec3 turn = move.head<3>() / m_lever;
        const Mat3 more = turn.norm() > 0.0 ? Mat3(Eigen::AngleAxisd(turn.norm(), turn.normalized())) : Mat3(Mat3::Identity());
        m_fit.turn = more * m_fit.turn;
        m_fit.shift += move.tail<3>();
        m_fit.settled = move.head<3>().norm() + move.tail<3>().norm() < 1e-5 * m_settings.radius;
    }

    void judge() {
        Mat6 normal;
        Vec6 right;
        gather(normal, right);
        const Mat6 spread = m_scatter * m_scatter * normal.inverse();
        m_fit.turnError = spread.diagonal().head<3>().cwiseSqrt() / m_lever;
        m_fit.shiftError = spread.diagonal().tail<3>().cwiseSqrt();
        double squares = 0.0;
        for (const PlanePair& each : m_pairs) {
            const Vec6 row = rowOf(each);
            squares += row.dot(spread * row);
        }
        m_fit.unevenness = unevenness();
        m_fit.error = std::sqrt(squares / static_cast<double>(m_pairs.size()) + m_fit.unevenness * m_fit.unevenness);
    }

    /// Means of patches differ by noise over the root of their points; what they differ by beyond it no averaging takes away.
    double unevenness() const {
        struct Patch {
            double sum = 0.0;
            double squares = 0.0;
            std::size_t pairs = 0;
        };
        std::map<std::array<std::int64_t, 3>, Patch> patches;
        for (const PlanePair& each : m_pairs) {
            const Vec3 cube = (each.place / (patchRadii * m_settings.radius)).array().floor();
            Patch& patch = patches[{std::llround(cube.x()), std::llround(cube.y()), std::llround(cube.z())}];
            // One sign for all that look one way.
            const bool downwards = each.normal.z() < 0.0 || (each.normal.z() == 0.0 && each.normal.sum() < 0.0);
            const double off = downwards ? -each.off : each.off;
            patch.sum += off;
            patch.squares += off * off;
            ++patch.pairs;
        }
        double beyond = 0.0;
        double count = 0.0;
        for (const auto& [cube, patch] : patches) {
            if (patch.pairs >= patchPairs) {
                const auto pairs = static_cast<double>(patch.pairs);
                const double mean = patch.sum / pairs;
                beyond += mean * mean - (patch.squares / pairs - mean * mean) / (pairs - 1.0);
                count += 1.0;
            }
        }
        return count > 0.0 ? std::sqrt(std::max(0.0, beyond / count)) : 0.0;
    }

    const PointIndex& m_first;
    const CloudFitSettings& m_settings;
    const Execution& m_execution;
    std::vector<Vec3> m_points;
    std::vector<PlanePair> m_pairs;
    double m_scatter = 0.0;
    double m_lever = 1.0;
    CloudFit m_fit;
};

}  // namespace

double CloudFit::angle() const {
    return Eigen::AngleAxisd(turn).angle();
}

double CloudFit::errorAt(const Vec3& place) const {
    const double shifted = shiftError.maxCoeff();
    const double turned = turnError.maxCoeff() * (place - about - shift).norm();
    return std::max(error, std::sqrt(shifted * shifted + turned * turned + unevenness * unevenness));
}

CloudFit fitCloud(const PointIndex& first, const std::vector<Vec3>& second, const CloudFitSettings& settings,
                  const Execution& execution) {
    return CloudFitting(first, second, settings, execution).fit();
}

Registration fittedOn(const std::optional<Registration>& before, const CloudFit& fit, const Aabb& around) {
    Registration both = movedOn(before.value_or(Registration{.about = fit.about}), fit.turn, fit.about, fit.shift);
    both.fitted = fit.pairs;
    both.fitBefore = fit.before;
    both.fitLeft = fit.after;
    both.error = fit.error;
    for (int corner = 0; corner < 8 && !around.isEmpty(); ++corner) {
        both.error = std::max(*both.error, fit.errorAt(around.corner(static_cast<Aabb::CornerType>(corner))));
    }
    return both;
}

}  // namespace rubble
