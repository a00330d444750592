#include "core/evidence/photographs/match_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/evidence/photographs/camera_search.h"
#include "core/evidence/photographs/confidence.h"

namespace rubble {

namespace {

/// Least share of the diagonal that clicks spread by.
constexpr double leastShare = 5e-5;
/// A third radial term, which no camera of ours has: only asked for by its residuals.
constexpr int thirdRadial = static_cast<int>(cameraParameters);

/// How the picture of a point moves with some numbers of a camera, [2, numbers].
Eigen::MatrixXd columnsOf(const CameraModel& camera, const Vec3& point, const std::vector<int>& numbers) {
    const CameraJacobian all = jacobianOf(camera, point);
    Eigen::MatrixXd columns(2, static_cast<Eigen::Index>(numbers.size()));
    for (std::size_t c = 0; c < numbers.size(); ++c) {
        const auto at = static_cast<Eigen::Index>(c);
        if (numbers[c] == thirdRadial) {
            const Vec3 p = camera.inCamera(point);
            columns.col(at) = all.col(10) * (p.head<2>() / p.z()).squaredNorm();
        } else {
            columns.col(at) = all.col(numbers[c]);
        }
    }
    return columns;
}

/// The sum of squares of the pairs used near a camera, by some of its numbers.
LinearFit fitNear(const CameraMatch& match, const MatchTask& task, const std::vector<int>& numbers) {
    const auto count = static_cast<Eigen::Index>(numbers.size());
    LinearFit fit{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
    for (std::size_t k = 0; k < task.pairs.size(); ++k) {
        if (match.used[k]) {
            const Eigen::MatrixXd columns = columnsOf(match.camera, task.pairs[k].model, numbers);
            fit.normal += columns.transpose() * columns;
            fit.slope += columns.transpose() * match.residuals[k];
            fit.sum += match.residuals[k].squaredNorm();
            fit.coordinates += 2.0;
        }
    }
    return fit;
}

/// The inverse of a matrix of numbers of different units; nothing if one of them is open.
std::optional<Eigen::MatrixXd> inverseOf(const Eigen::MatrixXd& normal) {
    const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0.0)) {
        return std::nullopt;
    }
    // Brought to one scale before their independence is judged.
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * normal * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
    constexpr double independent = 1e-13;
    if (!(axes.eigenvalues().minCoeff() > independent)) {
        return std::nullopt;
    }
    const Eigen::MatrixXd inverse =
        axes.eigenvectors() * axes.eigenvalues().cwiseInverse().asDiagonal() * axes.eigenvectors().transpose();
    return scale.cwiseInverse().asDiagonal() * inverse * scale.cwiseInverse().asDiagonal();
}

/// Longest half axis of the 95 % ellipsoid of three of the numbers.
double radiusOf(const CameraMatch& match, Eigen::Index first) {
    const Mat3 part = match.covariance.block<3, 3>(first, first);
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(part);
    return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()) * 3.0 * fisherQuantile(matchConfidence, 3.0, match.freedom));
}

std::vector<double> weightsOfUsed(const CameraMatch& match) {
    std::vector<double> weights;
    for (const bool used : match.used) {
        weights.push_back(used ? 1.0 : 0.0);
    }
    return weights;
}

/// The camera of an unknown lens: spread of the clicks, lens and pose depend on each other, and settle in a few rounds.
bool takeRegionWithLens(CameraMatch& match, const MatchTask& task) {
    constexpr int rounds = 5;
    constexpr double bestClicks = 0.1;  // of the least spread: targets measured by a program
    constexpr double worstClicks = 0.02;
    const double least = bestClicks * task.leastSpread();
    match.found = numbersToFind(task.known, true);
    FitRegion region;
    double sigma = std::max(least, match.sigma);
    for (int round = 0; round < rounds; ++round) {
        if (!refine(match.camera, task.pairs, weightsOfUsed(match), match.found, task.pull(match.camera, sigma))) {
            return false;
        }
        takeResiduals(match, task);
        const LinearFit fit = fitNear(match, task, match.found);
        const std::vector<int> pose(match.found.begin(), match.found.end() - 2);
        if (!inverseOf(fit.normal.topLeftCorner(fit.normal.rows() - 2, fit.normal.cols() - 2))) {
            return false;
        }
        region = regionWithLens(fit, match.camera.radial - task.known.radial, lensSpread(match.camera, task.known), least,
                                worstClicks * task.diagonal());
        const bool same = std::abs(region.sigma - sigma) < 1e-3 * sigma;
        sigma = region.sigma;
        if (same) {
            break;
        }
    }
    constexpr double freedomMost = 1000.0;
    match.sigma = region.sigma;
    match.freedom = static_cast<int>(std::clamp(region.freedom, 1.0, freedomMost));
    match.covariance = region.covariance;
    return match.covariance.allFinite();
}

/// Numbers that a camera was not given to find, and how much better the pairs would agree with them.
struct Misfit {
    int number = 0;          ///< the first of them
    double chance = 1.0;     ///< that residuals of the clicks alone would fall as much
    double place = 0.0;      ///< m, how far the camera would move
    Eigen::VectorXd change;  ///< of these numbers
};

/// What the residuals say of numbers that were not found, by linear theory (F test of what they add).
Misfit misfitOf(const CameraMatch& match, const MatchTask& task, const std::vector<int>& more) {
    Misfit misfit;
    misfit.number = more.front();
    std::vector<int> numbers = match.found;
    numbers.insert(numbers.end(), more.begin(), more.end());
    LinearFit fit = fitNear(match, task, numbers);
    const LensPull pull = task.pull(match.camera, match.sigma);
    for (std::size_t c = 0; c < match.found.size(); ++c) {
        if (const int term = match.found[c] - 9; term >= 0) {
            const auto at = static_cast<Eigen::Index>(c);
            fit.normal(at, at) += pull.weight[term];
            fit.slope[at] -= pull.weight[term] * (match.camera.radial[term] - pull.towards[term]);
        }
    }
    const auto inverse = inverseOf(fit.normal);
    const double count = static_cast<double>(more.size());
    const double rest = fit.coordinates - static_cast<double>(numbers.size());
    constexpr double freedomLeast = 2.0;
    if (!inverse || rest < freedomLeast) {
        return misfit;
    }
    const Eigen::VectorXd step = *inverse * fit.slope;
    const double gain = std::max(0.0, step.dot(fit.slope));
    const double least = task.leastSpread();
    const double spread = std::max(least * least, (fit.sum + pull.cost(match.camera) - gain) / rest);
    const double ratio = gain / count / spread;
    misfit.chance = incompleteBeta(0.5 * rest, 0.5 * count, rest / (rest + count * ratio));
    misfit.place = step.head<3>().norm();
    misfit.change = step.tail(static_cast<Eigen::Index>(more.size()));
    return misfit;
}

/// What the settings of a camera leave out that its residuals may ask for.
std::vector<std::vector<int>> leftOut(const CameraKnowledge& known) {
    std::vector<std::vector<int>> list;
    const int terms = known.radialTerms.value_or(2);
    list.push_back(terms == 0 ? std::vector{9, 10} : terms == 1 ? std::vector{10} : std::vector{thirdRadial});
    if (known.focal) {
        list.push_back({6});
    }
    if (!known.freePrincipal) {
        list.push_back({7, 8});
    }
    return list;
}

void addFinding(CameraMatch& match, const Message& what, std::string_view remedy) {
    match.findings.add(what, {what.id + ".remedy", std::string(remedy), {}});
}

void sayMisfit(CameraMatch& match, const MatchTask& task, const Misfit& misfit) {
    const Argument place{misfit.place, "m"};
    if (misfit.number == 6) {
        addFinding(
            match,
            {"camera.focal_doubted",
             "The points do not fit the focal length given, {0}: with {1} they would fit, and the camera would stand {2} from "
             "where it was found.",
             {{match.camera.focal, "px"}, {match.camera.focal + misfit.change[0], "px"}, place}},
            "Let the focal length be found. What a file notes is rounded, and holds for the whole picture only.");
    } else if (misfit.number == 7) {
        addFinding(match,
                   {"camera.principal_doubted",
                    "The points do not fit a lens whose axis meets the picture where it was said: it seems to be {0} off, and the "
                    "camera {1} from where it was found.",
                    {{misfit.change.norm(), "px"}, place}},
                   "Let the principal point be found, and look whether the photograph was cropped.");
    } else if (task.known.radialTerms.value_or(2) < 2) {
        addFinding(
            match,
            {"camera.lens_doubted",
             "The residuals go with the distance from the middle of the picture: the lens bends lines otherwise than was said. "
             "With its distortion found the camera would stand {0} from where it was found.",
             {place}},
            "Let the distortion be found automatically.");
    } else {
        addFinding(
            match,
            {"camera.lens_beyond",
             "The residuals go with the distance from the middle of the picture: two radial terms do not describe this lens. A "
             "third would move the camera by {0}.",
             {place}},
            "Take points nearer to the middle, or a picture whose distortion was taken out.");
    }
}

/// Says the greatest of what the spread of the clicks does not explain. True if there is any.
bool findMisfit(CameraMatch& match, const MatchTask& task) {
    constexpr double falseAlarms = 0.01;
    Misfit worst;
    const std::vector<std::vector<int>> list = leftOut(task.known);
    for (const std::vector<int>& more : list) {
        const Misfit misfit = misfitOf(match, task, more);
        if (misfit.chance < worst.chance) {
            worst = misfit;
        }
    }
    const bool any = worst.chance < falseAlarms / static_cast<double>(list.size());
    if (any) {
        sayMisfit(match, task, worst);
    }
    return any;
}

/// Nearest and farthest point used from the middle, over the distance of the corners.
std::array<double, 2> ringOf(const CameraMatch& match, const MatchTask& task) {
    std::array<double, 2> ring{1e300, 0.0};
    for (std::size_t k = 0; k < task.pairs.size(); ++k) {
        if (match.used[k]) {
            const double share = 2.0 * (task.pairs[k].picture - match.camera.principal).norm() / task.diagonal();
            ring = {std::min(ring[0], share), std::max(ring[1], share)};
        }
    }
    return ring;
}

/// What the points leave open of the radial terms that were found.
struct LensLeft {
    double share = 1.0;   ///< least part left of what was open before they were asked
    double corner = 0.0;  ///< standard deviation of where the corners lie, over their distance from the middle
};

LensLeft lensLeft(const CameraMatch& match, const MatchTask& task, Eigen::Index terms) {
    const Eigen::VectorXd share = cornerShare(match.camera, task.known).head(terms);
    const Eigen::VectorXd before = lensSpread(match.camera, task.known).head(terms);
    const Eigen::MatrixXd after = match.covariance.bottomRightCorner(terms, terms);
    const Eigen::MatrixXd left = before.cwiseInverse().asDiagonal() * after * before.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(left);
    return {std::sqrt(std::max(0.0, axes.eigenvalues()[0])), std::sqrt(std::max(0.0, share.dot(after * share)))};
}

/// Says it if the points tell little of a lens that was to be found.
void findUntoldLens(CameraMatch& match, const MatchTask& task) {
    constexpr double shareMost = 0.5;
    constexpr double cornerMost = 0.03;
    constexpr double ringLeast = 0.15;    // width, over the distance of the corners: in it any lens is one of another focal length
    constexpr double middleLeast = 0.35;  // within it no lens bends anything
    const auto terms =
        static_cast<Eigen::Index>(std::count_if(match.found.begin(), match.found.end(), [](int number) { return number >= 9; }));
    if (terms == 0) {
        return;
    }
    const LensLeft left = lensLeft(match, task, terms);
    const auto [nearest, farthest] = ringOf(match, task);
    const bool spread = farthest >= middleLeast && farthest - nearest >= ringLeast;
    if (spread && left.share <= shareMost && left.corner <= cornerMost) {
        return;
    }
    const auto percent = [](double of) { return Argument{std::round(100.0 * of)}; };
    addFinding(
        match,
        {"camera.lens_untold",
         "The points hardly tell the distortion of the lens from its focal length: they lie {0} to {1} % of the way from the "
         "middle of the picture to its corners. The regions allow for that; the corners may lie {2} % nearer or farther.",
         {percent(nearest), percent(farthest), percent(left.corner)}},
        "Add points near the middle and near the corners, or say that there is no distortion if it was taken out.");
}

}  // namespace

double MatchTask::diagonal() const {
    return std::hypot(known.width, known.height);
}

double MatchTask::leastSpread() const {
    return leastShare * diagonal();
}

LensPull MatchTask::pull(const CameraModel& camera, double sigma) const {
    LensPull pull{known.radial};
    if (!known.radialTerms) {
        pull.weight = sigma * sigma * lensSpread(camera, known).cwiseAbs2().cwiseInverse();
    }
    return pull;
}

std::vector<int> numbersToFind(const CameraKnowledge& known, bool lens) {
    std::vector<int> found{0, 1, 2, 3, 4, 5};
    if (!known.focal) {
        found.push_back(6);
    }
    if (known.freePrincipal) {
        found.push_back(7);
        found.push_back(8);
    }
    for (int k = 0; k < known.radialTerms.value_or(lens ? 2 : 0); ++k) {
        found.push_back(9 + k);
    }
    return found;
}

void takeResiduals(CameraMatch& match, const MatchTask& task) {
    match.residuals.clear();
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < task.pairs.size(); ++k) {
        const auto place = match.camera.project(task.pairs[k].model);
        const Eigen::Vector2d residual = place ? Eigen::Vector2d(task.pairs[k].picture - *place)
                                               : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
        match.residuals.push_back(residual);
        if (match.used[k]) {
            sum += residual.squaredNorm();
            ++count;
        }
    }
    match.freedom = 2 * count - numbersToPay(task.known);
    if (!task.known.radialTerms && match.found.back() == 10) {
        match.freedom -= std::min(2, match.freedom / 2);
    }
    match.rms = std::sqrt(sum / std::max(1, count));
    match.sigma = match.freedom > 0 ? std::sqrt(sum / match.freedom) : 0.0;
}

bool takeRegion(CameraMatch& match, const MatchTask& task) {
    if (!task.known.radialTerms) {
        return takeRegionWithLens(match, task);
    }
    const auto inverse = inverseOf(fitNear(match, task, match.found).normal);
    if (inverse) {
        match.covariance = match.sigma * match.sigma * *inverse;
    }
    return inverse && match.covariance.allFinite();
}

void takeVerdict(CameraMatch& match, const MatchTask& task) {
    Vec3 middle = Vec3::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < task.pairs.size(); ++k) {
        if (match.used[k]) {
            middle += task.pairs[k].model;
            count += 1.0;
        }
    }
    match.distance = (middle / count - match.camera.place).norm();
    match.placeRadius = radiusOf(match, 0);
    match.turnRadius = radiusOf(match, 3);
    const bool misfit = findMisfit(match, task);
    findUntoldLens(match, task);
    const double fit = match.rms / task.diagonal();
    const double open = match.placeRadius / match.distance;
    std::string_view word = "poor";
    match.verdict = MatchVerdict::Poor;
    if (fit <= 0.002 && open <= 0.02 && !misfit) {
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
         task.pairs.size(),
         {match.rms, "px"},
         {match.placeRadius, "m"},
         {match.distance, "m"},
         {match.turnRadius * 180.0 / std::numbers::pi, "degrees"}}};
}

}  // namespace rubble
