#include "core/evidence/surveys/pair_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"

namespace rubble {

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

constexpr std::size_t pairsLeast = 3;
/// Of the second to the greatest spread of the pairs: below it they lie on a line, and the turn about it is open.
constexpr double lineShare = 0.02;
/// Lengths of the survey and of the case that differ by more are of two units, or of wrong pairs.
constexpr double scaleMost = 0.01;
/// Of the greatest distance between pairs, and at least so many metres: a residual beyond both is a finding.
constexpr double residualShare = 0.005;
constexpr double residualLeast = 0.1;

/// Places about their middle.
struct Centred {
    Vec3 surveyed = Vec3::Zero();
    Vec3 placed = Vec3::Zero();
    Mat3 cross = Mat3::Zero();   ///< surveyed by placed
    Mat3 spread = Mat3::Zero();  ///< of the surveyed
    double spreadPlaced = 0.0;

    explicit Centred(std::span<const PlacePair> pairs) {
        for (const PlacePair& pair : pairs) {
            surveyed += pair.surveyed / static_cast<double>(pairs.size());
            placed += pair.placed / static_cast<double>(pairs.size());
        }
        for (const PlacePair& pair : pairs) {
            const Vec3 from = pair.surveyed - surveyed;
            cross += from * (pair.placed - placed).transpose();
            spread += from * from.transpose();
            spreadPlaced += (pair.placed - placed).squaredNorm();
        }
    }
};

void checkPairs(std::span<const PlacePair> pairs) {
    if (pairs.size() < pairsLeast) {
        throw UsageError({"pairs.few_places", "A survey is placed by three pairs or more, not by {0}", {pairs.size()}},
                         {"pairs.few_places.remedy", "Pick places that lie far apart and not on a line.", {}});
    }
    for (const PlacePair& pair : pairs) {
        if (!pair.surveyed.allFinite() || !pair.placed.allFinite()) {
            throw UsageError({"pairs.no_place", "The pair {0} has no place in the system of the case", {pair.name}},
                             {"pairs.no_place.remedy", "Check its numbers and the systems of survey and case.", {}});
        }
    }
}

/// How a small move changes a place: turns about the middle, then shifts.
Mat36 changeOf(const Vec3& fromMiddle) {
    Mat36 change;
    change << 0.0, fromMiddle.z(), -fromMiddle.y(), 1.0, 0.0, 0.0, -fromMiddle.z(), 0.0, fromMiddle.x(), 0.0, 1.0, 0.0,
        fromMiddle.y(), -fromMiddle.x(), 0.0, 0.0, 0.0, 1.0;
    return change;
}

/// m, standard deviation along each axis in the mean over the places. @param variance  m2, of one number of a pair
double errorAt(std::span<const PlacePair> pairs, const Centred& centred, const Aabb& site, double variance) {
    Mat6 normal = Mat6::Zero();
    for (const PlacePair& pair : pairs) {
        const Mat36 change = changeOf(pair.placed - centred.placed);
        normal += change.transpose() * change;
    }
    const Mat6 spread = variance * normal.inverse();
    double squares = 0.0;
    double count = 0.0;
    const auto add = [&](const Vec3& place) {
        const Mat36 change = changeOf(place - centred.placed);
        squares += (change * spread * change.transpose()).trace() / 3.0;
        count += 1.0;
    };
    for (int corner = 0; corner < 8 && !site.isEmpty(); ++corner) {
        add(site.corner(static_cast<Aabb::CornerType>(corner)));
    }
    for (std::size_t p = 0; p < pairs.size() && site.isEmpty(); ++p) {
        add(pairs[p].placed);
    }
    return std::sqrt(squares / count);
}

/// m, root mean square of what the points are stated to be off by; those of which nothing is stated are counted.
std::optional<double> controlOf(std::span<const PlacePair> pairs, Findings& findings) {
    double squares = 0.0;
    std::int64_t stated = 0;
    for (const PlacePair& pair : pairs) {
        squares += pair.deviation ? *pair.deviation * *pair.deviation : 0.0;
        stated += pair.deviation ? 1 : 0;
    }
    if (stated == 0) {
        return std::nullopt;
    }
    if (const auto unstated = static_cast<std::int64_t>(pairs.size()) - stated; unstated > 0) {
        findings.add({"pairs.control_partly",
                      "of some control points nobody states how accurate they are: they were taken as the others",
                      {}},
                     {"pairs.control_partly.remedy", "state it for each pair", {}}, {}, unstated);
    }
    return std::sqrt(squares / static_cast<double>(stated));
}

void judge(PairFit& fit, std::span<const PlacePair> pairs, double reach) {
    if (std::abs(fit.scale - 1.0) > scaleMost) {
        fit.findings.add({"pairs.scale", "lengths of the survey are {0} times as long in the case", {fit.scale}},
                         {"pairs.scale.remedy", "check the unit of the survey (feet, millimetres) and the pairs", {}});
    }
    const double most = std::max(residualLeast, residualShare * reach);
    std::int64_t bad = 0;
    std::size_t worst = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        bad += fit.residuals[p].norm() > most ? 1 : 0;
        worst = fit.residuals[p].norm() > fit.residuals[worst].norm() ? p : worst;
    }
    if (bad > 0) {
        fit.findings.add({"pairs.residual", "pairs lie farther than {0} from where the others place them", {{most, "m"}}},
                         {"pairs.residual.remedy", "pick them again, or leave them out", {}}, pairs[worst].name, bad);
    }
}

}  // namespace

PairFit fitPairs(std::span<const PlacePair> pairs, const Aabb& site) {
    checkPairs(pairs);
    const Centred centred(pairs);
    const Eigen::JacobiSVD<Mat3> spread(centred.spread);
    if (!(spread.singularValues()[1] > lineShare * lineShare * spread.singularValues()[0])) {
        throw UsageError({"pairs.line", "The pairs lie in one place or on a line: the turn about it is open", {}},
                         {"pairs.line.remedy", "Pick places that lie far apart and not on a line.", {}});
    }
    const Eigen::JacobiSVD<Mat3> svd(centred.cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 upright = Mat3::Identity();
    upright(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Mat3 turn = svd.matrixV() * upright * svd.matrixU().transpose();
    PairFit fit;
    fit.scale = std::sqrt(centred.spreadPlaced / centred.spread.trace());
    Registration still;
    still.about = centred.surveyed;
    fit.registration = movedOn(still, turn, centred.surveyed, centred.placed - centred.surveyed);
    fit.registration.pairs = static_cast<std::int64_t>(pairs.size());
    double squares = 0.0;
    double reach = 0.0;
    for (const PlacePair& pair : pairs) {
        fit.residuals.emplace_back(pair.placed - fit.registration(pair.surveyed));
        squares += fit.residuals.back().squaredNorm();
        reach = std::max(reach, 2.0 * (pair.placed - centred.placed).norm());
    }
    const auto count = static_cast<double>(pairs.size());
    fit.registration.pairsLeft = std::sqrt(squares / count);
    fit.registration.control = controlOf(pairs, fit.findings);
    fit.registration.error =
        std::hypot(errorAt(pairs, centred, site, squares / (3.0 * count - 6.0)), fit.registration.control.value_or(0.0));
    judge(fit, pairs, reach);
    return fit;
}

}  // namespace rubble
