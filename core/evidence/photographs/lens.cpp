#include "core/evidence/photographs/lens.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {

namespace {

/// One spread of the clicks and what follows from it.
struct SpreadGuess {
    double sigma = 0.0;
    double logWeight = 0.0;
    Eigen::MatrixXd covariance;
};

/// Numbers of different units brought to one scale, which inverts well.
Eigen::VectorXd scaleOf(const Eigen::MatrixXd& precision) {
    return precision.diagonal().cwiseMax(1e-300).cwiseSqrt();
}

SpreadGuess guessOf(const LinearFit& fit, const Eigen::Vector2d& off, const Eigen::Vector2d& spread, double sigma) {
    const Eigen::Index lens = fit.slope.size() - 2;
    const Eigen::Vector2d known = spread.cwiseAbs2().cwiseInverse();
    Eigen::MatrixXd precision = fit.normal / (sigma * sigma);
    precision.diagonal().tail<2>() += known;
    Eigen::VectorXd slope = fit.slope / (sigma * sigma);
    slope.segment<2>(lens) -= known.cwiseProduct(off);
    const Eigen::VectorXd scale = scaleOf(precision);
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * precision * scale.cwiseInverse().asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> root(scaled);
    const Eigen::VectorXd diagonal = Eigen::MatrixXd(root.matrixL()).diagonal().cwiseMax(1e-300);
    const Eigen::VectorXd shift = root.solve(slope.cwiseQuotient(scale));
    const double misfit = fit.sum / (sigma * sigma) + known.dot(off.cwiseAbs2()) - shift.dot(slope.cwiseQuotient(scale));
    const double logVolume = diagonal.array().log().sum() + scale.array().log().sum();
    SpreadGuess guess;
    guess.sigma = sigma;
    guess.logWeight = -fit.coordinates * std::log(sigma) - 0.5 * misfit - logVolume;
    guess.covariance = scale.cwiseInverse().asDiagonal() * root.solve(Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols())) *
                       scale.cwiseInverse().asDiagonal();
    return guess;
}

}  // namespace

int numbersToPay(const CameraKnowledge& known) {
    return 6 + (known.focal ? 0 : 1) + (known.freePrincipal ? 2 : 0) + known.radialTerms.value_or(0);
}

bool lensSearched(const CameraKnowledge& known, std::size_t pairs) {
    constexpr int leastFreedom = 4;  // two coordinates for the lens and two to tell the spread of the clicks
    return !known.radialTerms && 2 * static_cast<int>(pairs) - numbersToPay(known) >= leastFreedom;
}

Eigen::Vector2d cornerShare(const CameraModel& camera, const CameraKnowledge& known) {
    const double corner = 0.5 * std::hypot(known.width, known.height) / camera.focal;
    return {corner * corner, corner * corner * corner * corner};
}

Eigen::Vector2d lensSpread(const CameraModel& camera, const CameraKnowledge& known) {
    const Eigen::Vector2d share = cornerShare(camera, known);
    const Eigen::Vector2d bend = (camera.radial - known.radial).cwiseProduct(share);
    const Eigen::Vector2d usual(lensBend[0], lensBend[1]);
    return (usual.cwiseAbs2() + bend.cwiseAbs2()).cwiseSqrt().cwiseQuotient(share);
}

FitRegion regionWithLens(const LinearFit& fit, const Eigen::Vector2d& off, const Eigen::Vector2d& spread, double least,
                         double most) {
    constexpr int steps = 80;
    constexpr double freedomMost = 1e6;
    std::vector<SpreadGuess> guesses;
    double best = -1e300;
    for (int k = 0; k <= steps; ++k) {
        guesses.push_back(guessOf(fit, off, spread, least * std::pow(most / least, static_cast<double>(k) / steps)));
        best = std::max(best, guesses.back().logWeight);
    }
    double whole = 0.0;
    double precision = 0.0;
    for (const SpreadGuess& guess : guesses) {
        const double weight = std::exp(guess.logWeight - best);
        whole += weight;
        precision += weight / (guess.sigma * guess.sigma);
    }
    FitRegion region;
    region.sigma = std::sqrt(whole / precision);
    region.covariance = guessOf(fit, off, spread, region.sigma).covariance;
    // How far the region of the pose grows and shrinks with the spread gives its freedom: exactly that of the spread where nothing
    // is known of the lens, none to lose where all comes from the lens.
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> pose(region.covariance.topLeftCorner<6, 6>());
    double mean = 0.0;
    double square = 0.0;
    for (const SpreadGuess& guess : guesses) {
        const double narrow = 6.0 / pose.solve(guess.covariance.topLeftCorner<6, 6>()).trace();
        const double weight = std::exp(guess.logWeight - best) / whole;
        mean += weight * narrow;
        square += weight * narrow * narrow;
    }
    const double variance = std::max(square - mean * mean, 2.0 * mean * mean / freedomMost);
    region.freedom = 2.0 * mean * mean / variance;
    region.covariance /= mean;
    return region;
}

}  // namespace rubble
