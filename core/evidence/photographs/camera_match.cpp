#include "core/evidence/photographs/camera_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/evidence/photographs/camera_search.h"
#include "core/evidence/photographs/confidence.h"
#include "core/evidence/photographs/refusal.h"

namespace rubble {

namespace {

/// Share of the diagonal within which a pair agrees with a first guess.
constexpr double guessShare = 0.015;
/// A pair is set aside beyond so many standard deviations: of honest pairs three in ten thousand are.
constexpr double setAside = 4.0;
/// Least share of the diagonal taken for the standard deviation when pairs are set aside: nobody clicks better.
constexpr double leastShare = 5e-5;
constexpr double confidence = 0.95;
/// Points in a line or plane: extent across over extent along.
constexpr double flat = 0.01;
/// Guesses that are refined.
constexpr std::size_t guessesKept = 6;
/// Cameras that chance alone would offer, at most.
constexpr double chanceMost = 0.01;

std::vector<int> numbersToFind(const CameraKnowledge& known) {
    std::vector<int> found{0, 1, 2, 3, 4, 5};
    if (!known.focal) {
        found.push_back(6);
    }
    if (known.freePrincipal) {
        found.push_back(7);
        found.push_back(8);
    }
    for (int k = 0; k < known.radialTerms; ++k) {
        found.push_back(9 + k);
    }
    return found;
}

void checkNumbers(const std::vector<PointPair>& pairs, const CameraKnowledge& known) {
    constexpr int largestSide = 100000;
    if (known.width < 1 || known.height < 1 || std::max(known.width, known.height) > largestSide || known.radialTerms < 0 ||
        known.radialTerms > 2 || (known.focal && !(*known.focal > 0.0 && std::isfinite(*known.focal))) ||
        !known.radial.allFinite() || (known.principal && !known.principal->allFinite())) {
        refuse({"camera.settings",
                "A picture of {0} x {1} pixels with these settings of its camera cannot be matched.",
                {known.width, known.height}},
               "Give the size of the picture, a focal length above zero or none, and up to two radial terms.");
    }
    for (const PointPair& pair : pairs) {
        if (!pair.picture.allFinite() || !pair.model.allFinite()) {
            refuse({"camera.not_a_number", "The pair \"{0}\" has a coordinate that is not a number.", {pair.name}},
                   "Correct it or leave it out.");
        }
    }
}

/// Extents of the points along their principal axes, longest first, m.
Vec3 extentsOf(const std::vector<PointPair>& pairs, const std::vector<bool>& used) {
    Vec3 middle = Vec3::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (used[k]) {
            middle += pairs[k].model;
            count += 1.0;
        }
    }
    middle /= count;
    Mat3 spread = Mat3::Zero();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (used[k]) {
            spread += (pairs[k].model - middle) * (pairs[k].model - middle).transpose();
        }
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    return axes.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
}

void checkShape(const std::vector<PointPair>& pairs, const std::vector<bool>& used, const CameraKnowledge& known, bool wrongOnes) {
    const Vec3 extents = extentsOf(pairs, used);
    const std::string_view of = wrongOnes ? "The pairs that agree" : "The points";
    if (!(extents[1] > flat * extents[0])) {
        refuse({"camera.on_a_line", "{0} lie on one line: any camera around it would see them alike.", {of}},
               "Add points well away from that line.");
    }
    if (!known.focal && !(extents[2] > flat * extents[0])) {
        refuse({"camera.in_a_plane", "{0} lie in one plane, which leaves the focal length open.", {of}},
               "Add points in front of or behind that plane, or give the focal length.");
    }
}

/// The residuals of all pairs, and how the pairs marked spread.
void takeResiduals(CameraMatch& match, const std::vector<PointPair>& pairs) {
    match.residuals.clear();
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto place = match.camera.project(pairs[k].model);
        const Eigen::Vector2d residual = place ? Eigen::Vector2d(pairs[k].picture - *place)
                                               : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
        match.residuals.push_back(residual);
        if (match.used[k]) {
            sum += residual.squaredNorm();
            count += 1.0;
        }
    }
    match.freedom = static_cast<int>(2.0 * count) - static_cast<int>(match.found.size());
    match.rms = std::sqrt(sum / std::max(1.0, count));
    match.sigma = match.freedom > 0 ? std::sqrt(sum / match.freedom) : 0.0;
}

/// Pairs that a camera needs so that one of them being wrong shows.
std::size_t pairsNeeded(const std::vector<int>& found) {
    return (found.size() + 1) / 2 + 1;
}

/// Middle of the lengths of the residuals of the pairs marked, as a standard deviation of one coordinate.
double robustSigma(const CameraMatch& match) {
    std::vector<double> lengths;
    for (std::size_t k = 0; k < match.residuals.size(); ++k) {
        if (match.used[k]) {
            lengths.push_back(match.residuals[k].norm());
        }
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    // The median of a Rayleigh distribution is sigma sqrt(2 ln 2); fitted numbers make residuals smaller.
    const double freedom = std::max(1.0, 2.0 * static_cast<double>(lengths.size()) - static_cast<double>(match.found.size()));
    return *middle / std::sqrt(2.0 * std::numbers::ln2) * std::sqrt(2.0 * static_cast<double>(lengths.size()) / freedom);
}

std::vector<double> weightsOf(const std::vector<bool>& used) {
    std::vector<double> weights(used.size());
    std::transform(used.begin(), used.end(), weights.begin(), [](bool of) { return of ? 1.0 : 0.0; });
    return weights;
}

/// Draws the camera to what most pairs say: each pair counts the less the farther off it lies (Cauchy weights), over and over, so
/// that a wrong pair among the first guess loses its hold. False if it comes to nothing.
bool drawToMost(CameraMatch& match, const std::vector<PointPair>& pairs, double least) {
    constexpr int rounds = 10;
    constexpr double cauchy = 2.385;  // 95 % efficient for normal errors
    std::vector<double> weights = weightsOf(match.used);
    for (int round = 0; round < rounds; ++round) {
        if (!refine(match.camera, pairs, weights, match.found)) {
            return false;
        }
        takeResiduals(match, pairs);
        const double scale = cauchy * std::max(least, robustSigma(match));
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            weights[k] = match.used[k] ? 1.0 / (1.0 + match.residuals[k].squaredNorm() / (scale * scale)) : 0.0;
        }
    }
    return true;
}

/// Refines, sets pairs aside and takes them back, until none changes. False if too few remain.
bool settle(CameraMatch& match, const std::vector<PointPair>& pairs, double least) {
    constexpr int roundsMax = 20;
    if (!drawToMost(match, pairs, least)) {
        return false;
    }
    double sigma = robustSigma(match);
    for (int round = 0; round < roundsMax; ++round) {
        const double limit = setAside * std::max(least, sigma);
        std::vector<bool> used(pairs.size());
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            used[k] = match.residuals[k].norm() <= limit;
        }
        if (static_cast<std::size_t>(std::count(used.begin(), used.end(), true)) < pairsNeeded(match.found)) {
            return false;
        }
        const bool same = used == match.used && round > 0;
        match.used = used;
        if (!refine(match.camera, pairs, weightsOf(used), match.found)) {
            return false;
        }
        takeResiduals(match, pairs);
        if (same) {
            break;
        }
        sigma = match.sigma;
    }
    return true;
}

/// Sets aside, one by one, pairs without which the others fit so much better that chance hardly explains it (F test of the sum of
/// squares that each pair adds). A pair that holds the camera by itself has a small residual however wrong it is: only without it
/// the others tell.
void testEachPair(CameraMatch& match, const std::vector<PointPair>& pairs, double least) {
    constexpr double falseAlarms = 1e-3;  // of one set
    for (std::size_t agree = pairs.size() - match.wrong().size(); agree > pairsNeeded(match.found) && match.freedom > 3; --agree) {
        const double sum = match.sigma * match.sigma * match.freedom;
        CameraMatch best;
        double bestSum = sum;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            if (!match.used[k]) {
                continue;
            }
            CameraMatch without = match;
            without.used[k] = false;
            if (!refine(without.camera, pairs, weightsOf(without.used), match.found)) {
                continue;
            }
            takeResiduals(without, pairs);
            const double rest = without.sigma * without.sigma * without.freedom;
            if (rest < bestSum) {
                bestSum = rest;
                best = std::move(without);
            }
        }
        const double freedom = match.freedom - 2;
        const double ratio = 0.5 * (sum - bestSum) / std::max(least * least, bestSum / freedom);
        if (ratio <= fisherQuantile(1.0 - falseAlarms / static_cast<double>(pairs.size()), 2.0, freedom)) {
            return;
        }
        match = std::move(best);
    }
}

/// Expected number of cameras that as many pairs would agree with as well by chance, among all that were tried (a contrario: Moisan
/// & Stival 2004), as a natural logarithm.
double chanceOf(const CameraMatch& match, std::size_t pairs, const CameraKnowledge& known, double least) {
    double farthest = setAside * least;
    std::size_t agree = 0;
    for (std::size_t k = 0; k < match.used.size(); ++k) {
        if (match.used[k]) {
            ++agree;
            farthest = std::max(farthest, match.residuals[k].norm());
        }
    }
    const double n = static_cast<double>(pairs);
    const double k = static_cast<double>(agree);
    const double share = std::min(1.0, std::numbers::pi * farthest * farthest / (static_cast<double>(known.width) * known.height));
    constexpr double camerasTried = 1e4;
    const double choices = std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
    return std::log(camerasTried) + choices + (k - 0.5 * static_cast<double>(match.found.size())) * std::log(share);
}

/// Covariance by linear theory; false if the pairs leave something open.
bool takeCovariance(CameraMatch& match, const std::vector<PointPair>& pairs) {
    const auto count = static_cast<Eigen::Index>(match.found.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (match.used[k]) {
            const CameraJacobian all = jacobianOf(match.camera, pairs[k].model);
            Eigen::MatrixXd jacobian(2, count);
            for (Eigen::Index c = 0; c < count; ++c) {
                jacobian.col(c) = all.col(match.found[static_cast<std::size_t>(c)]);
            }
            normal += jacobian.transpose() * jacobian;
        }
    }
    // Numbers of different units are brought to one scale before their independence is judged.
    const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0.0)) {
        return false;
    }
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * normal * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
    constexpr double independent = 1e-13;
    if (!(axes.eigenvalues().minCoeff() > independent)) {
        return false;
    }
    const Eigen::MatrixXd inverse =
        axes.eigenvectors() * axes.eigenvalues().cwiseInverse().asDiagonal() * axes.eigenvectors().transpose();
    match.covariance =
        match.sigma * match.sigma * (scale.cwiseInverse().asDiagonal() * inverse * scale.cwiseInverse().asDiagonal());
    return match.covariance.allFinite();
}

/// Longest half axis of the 95 % ellipsoid of three of the numbers.
double radiusOf(const CameraMatch& match, Eigen::Index first) {
    const Mat3 part = match.covariance.block<3, 3>(first, first);
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(part);
    return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()) * 3.0 * fisherQuantile(confidence, 3.0, match.freedom));
}

void takeVerdict(CameraMatch& match, const std::vector<PointPair>& pairs, double diagonal) {
    Vec3 middle = Vec3::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (match.used[k]) {
            middle += pairs[k].model;
            count += 1.0;
        }
    }
    match.distance = (middle / count - match.camera.place).norm();
    match.placeRadius = radiusOf(match, 0);
    match.turnRadius = radiusOf(match, 3);
    const double fit = match.rms / diagonal;
    const double open = match.placeRadius / match.distance;
    std::string_view word = "poor";
    match.verdict = MatchVerdict::Poor;
    if (fit <= 0.002 && open <= 0.02) {
        match.verdict = MatchVerdict::Good;
        word = "good";
    } else if (fit <= 0.006 && open <= 0.1) {
        match.verdict = MatchVerdict::Usable;
        word = "usable";
    }
    match.words = {
        "camera.verdict",
        "The match is {0}: {1} of {2} pairs agree to {3} RMS; with 95 % confidence the camera stands within {4} of where it "
        "was found, {5} from the points, and looks within {6} of that direction.",
        {word,
         static_cast<std::size_t>(count),
         pairs.size(),
         {match.rms, "px"},
         {match.placeRadius, "m"},
         {match.distance, "m"},
         {match.turnRadius * 180.0 / std::numbers::pi, "degrees"}}};
}

bool samePose(const CameraModel& a, const CameraModel& b, double distance) {
    return (a.place - b.place).norm() < 0.02 * distance && a.toCamera.angularDistance(b.toCamera) < 0.02;
}

/// Refuses if a second pose fits nearly as well as the best one.
/// @param matches  as found from the guesses, `best` the first of them after all tests
void refuseTwo(const CameraMatch& best, const std::vector<CameraMatch>& matches, const std::vector<PointPair>& pairs) {
    const double distance = (best.camera.place - pairs.front().model).norm();
    for (std::size_t m = 1; m < matches.size(); ++m) {
        const CameraMatch& other = matches[m];
        const bool asMany = other.wrong().size() <= best.wrong().size();
        if (asMany && other.rms < 1.5 * best.rms + 1e-9 && !samePose(best.camera, other.camera, distance)) {
            refuse({"camera.two_poses",
                    "Two cameras see these points alike: one {0} from the other.",
                    {{(best.camera.place - other.camera.place).norm(), "m"}}},
                   "Add points in front of or behind the others.");
        }
    }
}

/// What each guess comes to, the best first.
std::vector<CameraMatch> matchesOf(const std::vector<PointPair>& pairs, const CameraKnowledge& known, double diagonal,
                                   const Execution& execution) {
    const double tolerance = guessShare * diagonal;
    std::vector<CameraMatch> matches;
    for (const CameraGuess& guess : cameraGuesses(pairs, known, tolerance, guessesKept, execution)) {
        CameraMatch match;
        match.camera = guess.camera;
        match.found = numbersToFind(known);
        for (const PointPair& pair : pairs) {
            const auto place = guess.camera.project(pair.model);
            match.used.push_back(place && (pair.picture - *place).norm() < tolerance);
        }
        const auto agree = static_cast<std::size_t>(std::count(match.used.begin(), match.used.end(), true));
        if (agree >= pairsNeeded(match.found) && settle(match, pairs, leastShare * diagonal)) {
            matches.push_back(std::move(match));
        }
    }
    std::stable_sort(matches.begin(), matches.end(), [](const CameraMatch& a, const CameraMatch& b) {
        const std::size_t wrongA = a.wrong().size();
        const std::size_t wrongB = b.wrong().size();
        return wrongA != wrongB ? wrongA < wrongB : a.rms < b.rms;
    });
    return matches;
}

}  // namespace

std::vector<std::size_t> CameraMatch::wrong() const {
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < used.size(); ++k) {
        if (!used[k]) {
            list.push_back(k);
        }
    }
    return list;
}

bool CameraMatch::holds(const CameraModel& other) const {
    Eigen::Matrix<double, 6, 1> off;
    off.head<3>() = other.place - camera.place;
    const Eigen::AngleAxisd turn(other.toCamera * camera.toCamera.conjugate());
    off.tail<3>() = turn.angle() * turn.axis();
    const Eigen::Matrix<double, 6, 6> pose = covariance.topLeftCorner<6, 6>();
    return off.dot(pose.ldlt().solve(off)) <= 6.0 * fisherQuantile(confidence, 6.0, freedom);
}

CameraMatch matchCamera(const std::vector<PointPair>& given, const CameraKnowledge& known, const Execution& execution) {
    checkNumbers(given, known);
    const std::vector<int> found = numbersToFind(known);
    const std::size_t needed = std::max<std::size_t>(pairsNeeded(found), 4);
    if (given.size() < needed) {
        refuse({"camera.too_few",
                "{0} pairs are too few to find {1} numbers of a camera: it takes {2}.",
                {given.size(), found.size(), needed}},
               "Add pairs, or give the focal length.");
    }
    checkShape(given, std::vector<bool>(given.size(), true), known, false);
    // Coordinates of a country would cost the digits that matter.
    Vec3 middle = Vec3::Zero();
    for (const PointPair& pair : given) {
        middle += pair.model / static_cast<double>(given.size());
    }
    std::vector<PointPair> pairs = given;
    for (PointPair& pair : pairs) {
        pair.model -= middle;
    }
    const double diagonal = std::hypot(known.width, known.height);
    std::vector<CameraMatch> matches = matchesOf(pairs, known, diagonal, execution);
    const bool believable =
        !matches.empty() && chanceOf(matches.front(), pairs.size(), known, leastShare * diagonal) < std::log(chanceMost);
    if (!believable) {
        refuse({"camera.no_agreement", "No camera sees enough of these {0} pairs where the picture shows them.", {pairs.size()}},
               "Check which point belongs to which, the size of the picture and the focal length; more good pairs show which ones "
               "are wrong.");
    }
    CameraMatch match = matches.front();
    testEachPair(match, pairs, leastShare * diagonal);
    checkShape(pairs, match.used, known, true);
    refuseTwo(match, matches, pairs);
    if (!takeCovariance(match, pairs)) {
        refuse({"camera.left_open", "These pairs leave the camera open: other cameras see them alike.", {}},
               "Add points at other distances and in other corners of the picture, or find fewer numbers.");
    }
    takeVerdict(match, pairs, diagonal);
    match.camera.place += middle;
    return match;
}

}  // namespace rubble
