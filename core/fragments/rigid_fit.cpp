#include "core/fragments/rigid_fit.h"

#include <Eigen/Eigenvalues>

namespace rubble {

namespace {

/// A principal moment this small beside the largest is rounding.
constexpr double singularMoment = 1e-12;

struct Inertia {
    Mat3 tensor;
    Mat3 inverse;  ///< pseudo-inverse where a principal moment vanishes
};

/// Inertia tensor from the second moments of mass about the centre, each principal one at least `least` (kg m2).
Inertia inertiaOf(const Mat3& secondMoments, double least) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(secondMoments);
    const Vec3 moments = principal.eigenvalues().cwiseMax(least);
    const Vec3 inertia = Vec3::Constant(moments.sum()) - moments;
    const Mat3& axes = principal.eigenvectors();
    Vec3 inverse;
    for (int i = 0; i < 3; ++i) {
        inverse[i] = inertia[i] > singularMoment * inertia.maxCoeff() ? 1.0 / inertia[i] : 0.0;
    }
    const bool raised = principal.eigenvalues()[0] < least;
    return {raised ? Mat3(axes * inertia.asDiagonal() * axes.transpose())
                   : Mat3(secondMoments.trace() * Mat3::Identity() - secondMoments),
            axes * inverse.asDiagonal() * axes.transpose()};
}

}  // namespace

Momenta& Momenta::operator+=(const Momenta& other) {
    mass += other.mass;
    linear += other.linear;
    angular += other.angular;
    kineticEnergy += other.kineticEnergy;
    return *this;
}

Momenta rigidMomenta(double mass, const Vec3& x, const Mat3& inertia, const Vec3& v, const Vec3& w) {
    const Vec3 spin = inertia * w;
    return {mass, mass * v, x.cross(mass * v) + spin, 0.5 * mass * v.squaredNorm() + 0.5 * w.dot(spin)};
}

RigidFit fitRigidMotion(const ConsistentMass& mass, const Corners& positions, const Corners& velocities, double leastHalfExtent) {
    const Eigen::Matrix<double, 8, 1> corner = mass.matrix.rowwise().sum();
    RigidFit fit;
    fit.field.mass = corner.sum();
    // About the mean of the corners first: far from the origin the differences would drown in rounding.
    const Vec3 middle = positions.rowwise().mean();
    const Vec3 offset = (positions.colwise() - middle) * corner / fit.field.mass;
    fit.centre = middle + offset;
    const Corners arm = (positions.colwise() - middle).colwise() - offset;

    const Corners momentum = velocities * mass.matrix;
    fit.field.linear = momentum.rowwise().sum();
    fit.velocity = fit.field.linear / fit.field.mass;
    const Mat3 moment = arm * ((velocities.colwise() - fit.velocity) * mass.matrix).transpose();
    const Vec3 spin(moment(1, 2) - moment(2, 1), moment(2, 0) - moment(0, 2), moment(0, 1) - moment(1, 0));
    fit.field.angular = fit.centre.cross(fit.field.linear) + spin;
    fit.field.kineticEnergy = 0.5 * momentum.cwiseProduct(velocities).sum();

    const Mat3 raw = arm * mass.matrix * arm.transpose();
    const Inertia inertia = inertiaOf(0.5 * (raw + raw.transpose()), fit.field.mass * leastHalfExtent * leastHalfExtent / 3.0);
    fit.inertia = inertia.tensor;
    fit.angularVelocity = inertia.inverse * spin;
    return fit;
}

}  // namespace rubble
