#include "core/evidence/photographs/camera_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/evidence/photographs/three_point_pose.h"

namespace rubble {

namespace {

/// Triples tried at most.
constexpr std::size_t triplesMax = 300;
/// Focal lengths tried, over the longer side of the picture: from 120 to 12 degrees across, each 1.3 times the one before.
constexpr std::array<double, 12> focalSteps{0.29, 0.38, 0.49, 0.64, 0.83, 1.08, 1.4, 1.82, 2.37, 3.08, 4.0, 5.2};
/// Bends of a lens tried, at the corners of the picture over their distance from its middle.
constexpr std::array<double, 3> bendSteps{0.0, -0.12, 0.08};

using Triple = std::array<std::size_t, 3>;

std::vector<Triple> triplesOf(std::size_t count) {
    std::vector<Triple> triples;
    const std::size_t all = count * (count - 1) * (count - 2) / 6;
    if (all <= triplesMax) {
        for (std::size_t a = 0; a < count; ++a) {
            for (std::size_t b = a + 1; b < count; ++b) {
                for (std::size_t c = b + 1; c < count; ++c) {
                    triples.push_back({a, b, c});
                }
            }
        }
        return triples;
    }
    // The same sequence every time; taking the remainder prefers no pair by more than 1e-8.
    std::mt19937 sequence(20131);
    while (triples.size() < triplesMax) {
        const Triple triple{sequence() % count, sequence() % count, sequence() % count};
        if (triple[0] != triple[1] && triple[0] != triple[2] && triple[1] != triple[2]) {
            triples.push_back(triple);
        }
    }
    return triples;
}

bool alike(const CameraModel& a, const CameraModel& b, double scale) {
    return (a.place - b.place).norm() < 0.02 * scale && a.toCamera.angularDistance(b.toCamera) < 0.02 &&
           std::abs(std::log(a.focal / b.focal)) < 0.1;
}

void keep(std::vector<CameraGuess>& guesses, const CameraGuess& guess, double scale, std::size_t most) {
    for (CameraGuess& other : guesses) {
        if (alike(other.camera, guess.camera, scale)) {
            if (guess.cost < other.cost) {
                other = guess;
            }
            return;
        }
    }
    guesses.push_back(guess);
    std::stable_sort(guesses.begin(), guesses.end(), [](const CameraGuess& a, const CameraGuess& b) { return a.cost < b.cost; });
    guesses.resize(std::min(guesses.size(), most));
}

double sumOfSquares(const CameraModel& camera, const std::vector<PointPair>& pairs, const std::vector<double>& weights,
                    const LensPull& pull) {
    double sum = pull.cost(camera);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (weights[k] > 0.0) {
            const auto place = camera.project(pairs[k].model);
            sum += place ? weights[k] * (pairs[k].picture - *place).squaredNorm() : std::numeric_limits<double>::infinity();
        }
    }
    return camera.focal > 0.0 && std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace

CameraGuess judged(const CameraModel& camera, const std::vector<PointPair>& pairs, double tolerance) {
    CameraGuess guess{camera, 0.0, 0};
    for (const PointPair& pair : pairs) {
        const auto place = camera.project(pair.model);
        const double share = place ? (pair.picture - *place).squaredNorm() / (tolerance * tolerance) : 1.0;
        guess.agree += share < 1.0;
        guess.cost += std::min(1.0, share);
    }
    return guess;
}

namespace {

/// Cameras without place and direction that a search begins from.
std::vector<CameraModel> lensesToTry(const CameraKnowledge& known, std::size_t pairs) {
    std::vector<double> focals;
    if (known.focal) {
        focals.push_back(*known.focal);
    } else {
        for (const double step : focalSteps) {
            focals.push_back(step * std::max(known.width, known.height));
        }
    }
    const auto bends = std::span(bendSteps).first(lensSearched(known, pairs) ? bendSteps.size() : 1);
    std::vector<CameraModel> lenses;
    for (const double focal : focals) {
        for (const double bend : bends) {
            CameraModel& lens = lenses.emplace_back();
            lens.focal = focal;
            lens.principal = known.principal.value_or(Eigen::Vector2d(0.5 * known.width, 0.5 * known.height));
            lens.radial = known.radial;
            lens.radial[0] += bend / cornerShare(lens, known)[0];
        }
    }
    return lenses;
}

}  // namespace

std::vector<CameraGuess> cameraGuesses(const std::vector<PointPair>& pairs, const CameraKnowledge& known, double tolerance,
                                       std::size_t most, const Execution& execution) {
    std::vector<CameraGuess> guesses;
    const std::vector<Triple> triples = triplesOf(pairs.size());
    for (CameraModel camera : lensesToTry(known, pairs.size())) {
        execution.check();
        std::vector<Vec3> rays;
        for (const PointPair& pair : pairs) {
            rays.push_back(rayOf(camera, pair.picture));
        }
        for (const Triple& t : triples) {
            const std::array<Vec3, 3> world{pairs[t[0]].model, pairs[t[1]].model, pairs[t[2]].model};
            for (const CameraPose& pose : threePointPoses(world, {rays[t[0]], rays[t[1]], rays[t[2]]})) {
                camera.place = pose.place;
                camera.toCamera = pose.toCamera;
                const CameraGuess guess = judged(camera, pairs, tolerance);
                if (guesses.size() < most || guess.cost < guesses.back().cost) {
                    keep(guesses, guess, (pose.place - world[0]).norm(), most);
                }
            }
        }
    }
    return guesses;
}

bool refine(CameraModel& camera, const std::vector<PointPair>& pairs, const std::vector<double>& weights,
            std::span<const int> found, const LensPull& pull) {
    constexpr int roundsMax = 100;
    const auto count = static_cast<Eigen::Index>(found.size());
    double sum = sumOfSquares(camera, pairs, weights, pull);
    double damping = 1e-3;
    for (int round = 0; round < roundsMax && std::isfinite(sum); ++round) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(count);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            if (weights[k] > 0.0) {
                const CameraJacobian all = jacobianOf(camera, pairs[k].model);
                Eigen::MatrixXd jacobian(2, count);
                for (Eigen::Index c = 0; c < count; ++c) {
                    jacobian.col(c) = all.col(found[static_cast<std::size_t>(c)]);
                }
                normal += weights[k] * jacobian.transpose() * jacobian;
                slope += weights[k] * jacobian.transpose() * (pairs[k].picture - *camera.project(pairs[k].model));
            }
        }
        for (Eigen::Index c = 0; c < count; ++c) {
            if (const int term = found[static_cast<std::size_t>(c)] - 9; term >= 0) {
                normal(c, c) += pull.weight[term];
                slope[c] -= pull.weight[term] * (camera.radial[term] - pull.towards[term]);
            }
        }
        bool better = false;
        double gain = 0.0;
        for (; !better && damping < 1e12; damping *= better ? 0.1 : 10.0) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping * normal.diagonal();
            const Eigen::VectorXd change = damped.ldlt().solve(slope);
            CameraStep step = CameraStep::Zero();
            for (Eigen::Index c = 0; c < count; ++c) {
                step[found[static_cast<std::size_t>(c)]] = change[c];
            }
            const CameraModel next = stepped(camera, step);
            const double nextSum =
                step.allFinite() ? sumOfSquares(next, pairs, weights, pull) : std::numeric_limits<double>::infinity();
            better = nextSum <= sum;
            if (better) {
                gain = sum - nextSum;
                camera = next;
                sum = nextSum;
            }
        }
        if (!better || gain <= 1e-14 * sum) {
            break;
        }
        damping = std::max(damping, 1e-12);
    }
    return std::isfinite(sum);
}

}  // namespace rubble
