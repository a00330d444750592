#pragma once

#include <Eigen/Dense>

#include <array>

#include "core/evidence/photographs/camera_model.h"
#include "core/scenario/photograph.h"

namespace rubble {

/// How far real lenses bend: what each radial term moves the corners of a picture by, over their distance from its middle, as a
/// standard deviation. Phones and corrected pictures stay below 0.02, wide angles of action cameras and drones reach 0.2.
inline constexpr std::array<double, 2> lensBend{0.1, 0.05};

/// Draws the radial terms of a lens back to what is known of it: adds weight * (terms - towards)^2 to a sum of squares.
struct LensPull {
    Eigen::Vector2d towards{0.0, 0.0};
    Eigen::Vector2d weight{0.0, 0.0};  ///< px^2

    double cost(const CameraModel& camera) const { return weight.dot((camera.radial - towards).cwiseAbs2()); }
};

/// How many numbers of a camera pairs must pay for: all but the terms of a lens of which nothing is known, since what the points do
/// not say of it is taken from real lenses.
int numbersToPay(const CameraKnowledge& known);
/// Whether so many pairs say enough of an unknown lens to look for it with the camera.
bool lensSearched(const CameraKnowledge& known, std::size_t pairs);

/// What each radial term moves the corners of the picture by where it is 1, over their distance from the middle. [2]
Eigen::Vector2d cornerShare(const CameraModel& camera, const CameraKnowledge& known);
/// Standard deviations of the radial terms of a lens of which nothing else is known, about `known.radial`. A lens that was found to
/// bend more than most widens them: it is not drawn back. [2]
Eigen::Vector2d lensSpread(const CameraModel& camera, const CameraKnowledge& known);

/// A sum of squares near a camera.
struct LinearFit {
    Eigen::MatrixXd normal;    ///< of the numbers, [numbers, numbers]
    Eigen::VectorXd slope;     ///< half of how the sum falls with each number, [numbers]
    double sum = 0.0;          ///< px^2
    double coordinates = 0.0;  ///< of clicks in it
};

/// What residuals say of the numbers of a camera.
struct FitRegion {
    double sigma = 0.0;          ///< px, of one coordinate of a click
    double freedom = 0.0;        ///< with which it is known
    Eigen::MatrixXd covariance;  ///< of the numbers, by that spread
};

/// The region of a camera whose last two numbers are the radial terms of an unknown lens. The spread of the clicks is weighed over
/// all that clicks may have, by how well each explains the residuals (a flat prior of its logarithm); the lens has that of real
/// lenses. What the points say of the lens narrows the region, what they leave open stays in it.
/// @param off     radial terms less those that are known [2]
/// @param spread  their standard deviations before the points are asked [2]
/// @param least, most  px, spreads that clicks may have
FitRegion regionWithLens(const LinearFit& fit, const Eigen::Vector2d& off, const Eigen::Vector2d& spread, double least,
                         double most);

}  // namespace rubble
