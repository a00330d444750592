#include "core/evidence/photographs/camera_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/evidence/photographs/camera_search.h"
#include "core/evidence/photographs/confidence.h"
#include "core/evidence/photographs/match_region.h"
#include "core/evidence/photographs/refusal.h"

namespace rubble {

namespace {

/// Share of the diagonal within which a pair agrees with a first guess.
constexpr double guessShare = 0.015;
/// A pair is set aside where so few honest ones are as far off: beyond four standard deviations, if these are well known.
constexpr double honestBeyond = 3.4e-4;
/// Points in a line or plane: extent across over extent along.
constexpr double flat = 0.01;
/// Guesses that are refined.
constexpr std::size_t guessesKept = 6;
/// Cameras that chance alone would offer, at most.
constexpr double chanceMost = 0.01;

void checkNumbers(const std::vector<PointPair>& pairs, const CameraKnowledge& known) {
    constexpr int largestSide = 100000;
    if (known.width < 1 || known.height < 1 || std::max(known.width, known.height) > largestSide ||
        known.radialTerms.value_or(0) < 0 || known.radialTerms.value_or(0) > 2 ||
        (known.focal && !(*known.focal > 0.0 && std::isfinite(*known.focal))) || !known.radial.allFinite() ||
        (known.principal && !known.principal->allFinite())) {
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

/// Pairs that a camera needs so that one of them being wrong shows.
std::size_t pairsNeeded(const CameraKnowledge& known) {
    return static_cast<std::size_t>(numbersToPay(known) + 1) / 2 + 1;
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
    const double freedom = std::max(1, match.freedom);
    return *middle / std::sqrt(2.0 * std::numbers::ln2) * std::sqrt(2.0 * static_cast<double>(lengths.size()) / freedom);
}

std::vector<double> weightsOf(const std::vector<bool>& used) {
    std::vector<double> weights(used.size());
    std::transform(used.begin(), used.end(), weights.begin(), [](bool of) { return of ? 1.0 : 0.0; });
    return weights;
}

/// Standard deviations beyond which a pair is set aside, by the freedom with which these are known (Fisher's F of two coordinates).
double setAside(int freedom) {
    const double known = std::max(2, freedom);
    return std::sqrt(known * (std::pow(honestBeyond, -2.0 / known) - 1.0));
}

bool refineMatch(CameraMatch& match, const MatchTask& task, const std::vector<double>& weights, double sigma) {
    return refine(match.camera, task.pairs, weights, match.found, task.pull(match.camera, sigma));
}

/// Draws the camera to what most pairs say: each pair counts the less the farther off it lies (Cauchy weights), over and over, so
/// that a wrong pair among the first guess loses its hold. False if it comes to nothing.
bool drawToMost(CameraMatch& match, const MatchTask& task) {
    constexpr int rounds = 10;
    constexpr double cauchy = 2.385;  // 95 % efficient for normal errors
    std::vector<double> weights = weightsOf(match.used);
    takeResiduals(match, task);
    for (int round = 0; round < rounds; ++round) {
        if (!refineMatch(match, task, weights, std::max(task.leastSpread(), robustSigma(match)))) {
            return false;
        }
        takeResiduals(match, task);
        const double scale = cauchy * std::max(task.leastSpread(), robustSigma(match));
        for (std::size_t k = 0; k < weights.size(); ++k) {
            weights[k] = match.used[k] ? 1.0 / (1.0 + match.residuals[k].squaredNorm() / (scale * scale)) : 0.0;
        }
    }
    return true;
}

/// Refines, sets pairs aside and takes them back, until none changes. False if too few remain.
bool settle(CameraMatch& match, const MatchTask& task) {
    constexpr int roundsMax = 20;
    const double least = task.leastSpread();
    if (!drawToMost(match, task)) {
        return false;
    }
    double sigma = robustSigma(match);
    for (int round = 0; round < roundsMax; ++round) {
        const double limit = setAside(match.freedom) * std::max(least, sigma);
        std::vector<bool> used(task.pairs.size());
        for (std::size_t k = 0; k < used.size(); ++k) {
            used[k] = match.residuals[k].norm() <= limit;
        }
        if (static_cast<std::size_t>(std::count(used.begin(), used.end(), true)) < pairsNeeded(task.known)) {
            return false;
        }
        const bool same = used == match.used && round > 0;
        match.used = used;
        if (!refineMatch(match, task, weightsOf(used), std::max(least, sigma))) {
            return false;
        }
        takeResiduals(match, task);
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
void testEachPair(CameraMatch& match, const MatchTask& task) {
    constexpr double falseAlarms = 1e-3;  // of one set
    const double least = task.leastSpread();
    const std::size_t count = task.pairs.size();
    for (std::size_t agree = count - match.wrong().size(); agree > pairsNeeded(task.known) && match.freedom > 3; --agree) {
        const double sum = match.sigma * match.sigma * match.freedom;
        CameraMatch best;
        double bestSum = sum;
        for (std::size_t k = 0; k < count; ++k) {
            if (!match.used[k]) {
                continue;
            }
            CameraMatch without = match;
            without.used[k] = false;
            if (!refineMatch(without, task, weightsOf(without.used), std::max(least, match.sigma))) {
                continue;
            }
            takeResiduals(without, task);
            const double rest = without.sigma * without.sigma * without.freedom;
            if (rest < bestSum) {
                bestSum = rest;
                best = std::move(without);
            }
        }
        const double freedom = match.freedom - 2;
        const double ratio = 0.5 * (sum - bestSum) / std::max(least * least, bestSum / freedom);
        if (ratio <= fisherQuantile(1.0 - falseAlarms / static_cast<double>(count), 2.0, freedom)) {
            return;
        }
        match = std::move(best);
    }
}

/// Expected number of cameras that as many pairs would agree with as well by chance, among all that were tried (a contrario: Moisan
/// & Stival 2004), as a natural logarithm.
double chanceOf(const CameraMatch& match, const MatchTask& task) {
    const CameraKnowledge& known = task.known;
    double farthest = setAside(match.freedom) * task.leastSpread();
    std::size_t agree = 0;
    for (std::size_t k = 0; k < match.used.size(); ++k) {
        if (match.used[k]) {
            ++agree;
            farthest = std::max(farthest, match.residuals[k].norm());
        }
    }
    const double n = static_cast<double>(task.pairs.size());
    const double k = static_cast<double>(agree);
    const double share = std::min(1.0, std::numbers::pi * farthest * farthest / (static_cast<double>(known.width) * known.height));
    constexpr double camerasTried = 1e4;
    // An unknown lens makes as many cameras of one as it can move the corners of the picture by more than that.
    double lenses = 0.0;
    if (lensSearched(known, task.pairs.size())) {
        for (const double bend : lensBend) {
            lenses += std::log(std::max(1.0, 0.5 * bend * task.diagonal() / farthest));
        }
    }
    const double choices = std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
    return std::log(camerasTried) + lenses + choices + (k - 0.5 * numbersToPay(known)) * std::log(share);
}

bool samePose(const CameraModel& a, const CameraModel& b, double distance) {
    return (a.place - b.place).norm() < 0.02 * distance && a.toCamera.angularDistance(b.toCamera) < 0.02;
}

/// How well a camera explains the pairs, px: its residuals, and how unusual its lens is.
double fitOf(const CameraMatch& match, const MatchTask& task) {
    const double used = static_cast<double>(match.used.size() - match.wrong().size());
    const LensPull pull = task.pull(match.camera, std::max(task.leastSpread(), match.sigma));
    return std::sqrt(match.rms * match.rms + pull.cost(match.camera) / used);
}

/// Refuses if a second pose fits nearly as well as the best one.
/// @param matches  as found from the guesses, `best` the first of them after all tests
void refuseTwo(const CameraMatch& best, const std::vector<CameraMatch>& matches, const MatchTask& task) {
    const double distance = (best.camera.place - task.pairs.front().model).norm();
    const double limit = 1.5 * fitOf(best, task) + 1e-9;
    for (std::size_t m = 1; m < matches.size(); ++m) {
        const CameraMatch& other = matches[m];
        const bool asMany = other.wrong().size() <= best.wrong().size();
        if (asMany && fitOf(other, task) < limit && !samePose(best.camera, other.camera, distance)) {
            refuse({"camera.two_poses",
                    "Two cameras see these points alike: one {0} from the other.",
                    {{(best.camera.place - other.camera.place).norm(), "m"}}},
                   "Add points in front of or behind the others.");
        }
    }
}

/// What each guess comes to, the best first.
std::vector<CameraMatch> matchesOf(const MatchTask& task, const Execution& execution) {
    const double tolerance = guessShare * task.diagonal();
    const bool lens = lensSearched(task.known, task.pairs.size());
    std::vector<CameraMatch> matches;
    for (const CameraGuess& guess : cameraGuesses(task.pairs, task.known, tolerance, guessesKept, execution)) {
        CameraMatch match;
        match.camera = guess.camera;
        match.found = numbersToFind(task.known, lens);
        for (const PointPair& pair : task.pairs) {
            const auto place = guess.camera.project(pair.model);
            match.used.push_back(place && (pair.picture - *place).norm() < tolerance);
        }
        const auto agree = static_cast<std::size_t>(std::count(match.used.begin(), match.used.end(), true));
        if (agree >= pairsNeeded(task.known) && settle(match, task)) {
            matches.push_back(std::move(match));
        }
    }
    std::stable_sort(matches.begin(), matches.end(), [&](const CameraMatch& a, const CameraMatch& b) {
        const std::size_t wrongA = a.wrong().size();
        const std::size_t wrongB = b.wrong().size();
        return wrongA != wrongB ? wrongA < wrongB : fitOf(a, task) < fitOf(b, task);
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
    return off.dot(pose.ldlt().solve(off)) <= 6.0 * fisherQuantile(matchConfidence, 6.0, freedom);
}

CameraMatch matchCamera(const std::vector<PointPair>& given, const CameraKnowledge& known, const Execution& execution) {
    checkNumbers(given, known);
    const std::size_t needed = std::max<std::size_t>(pairsNeeded(known), 4);
    if (given.size() < needed) {
        refuse({"camera.too_few",
                "{0} pairs are too few to find {1} numbers of a camera: it takes {2}.",
                {given.size(), numbersToPay(known), needed}},
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
    const MatchTask task{pairs, known};
    const std::vector<CameraMatch> matches = matchesOf(task, execution);
    const bool believable = !matches.empty() && chanceOf(matches.front(), task) < std::log(chanceMost);
    if (!believable) {
        refuse({"camera.no_agreement", "No camera sees enough of these {0} pairs where the picture shows them.", {pairs.size()}},
               "Check which point belongs to which, the size of the picture and the focal length; more good pairs show which ones "
               "are wrong.");
    }
    CameraMatch match = matches.front();
    testEachPair(match, task);
    checkShape(pairs, match.used, known, true);
    refuseTwo(match, matches, task);
    if (!takeRegion(match, task)) {
        refuse({"camera.left_open", "These pairs leave the camera open: other cameras see them alike.", {}},
               "Add points at other distances and in other corners of the picture, or find fewer numbers.");
    }
    takeVerdict(match, task);
    match.camera.place += middle;
    return match;
}

bool cameraStated(const Photograph& photograph) {
    return std::any_of(photograph.pairs.begin(), photograph.pairs.end(),
                       [](const PointPair& pair) { return pair.name.starts_with(statedPairName); });
}

CameraMatch matchPhotograph(const Photograph& photograph, const Execution& execution) {
    CameraMatch match = matchCamera(photograph.pairs, photograph.camera, execution);
    if (cameraStated(photograph)) {
        match.placeRadius = match.turnRadius = std::numeric_limits<double>::quiet_NaN();
        match.words = {
            "camera.stated", "as the cloud states it for its picture: how well place and turn are known nobody said", {}};
    }
    return match;
}

}  // namespace rubble
