#include "core/fragments/consistent_mass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rubble {

namespace {

constexpr int pointCount = 27;

/// Trilinear shape functions, their derivatives and the weights at the Gauss points.
struct Quadrature {
    Eigen::Matrix<double, 8, pointCount> shape;
    std::array<Eigen::Matrix<double, 8, 3>, pointCount> gradient;
    Eigen::Matrix<double, pointCount, 1> weight;
};

constexpr std::array<std::array<int, 3>, 8> cornerSigns{{{-1, -1, -1},
                                                         {1, -1, -1},
                                                         {1, 1, -1},
                                                         {-1, 1, -1},  //
                                                         {-1, -1, 1},
                                                         {1, -1, 1},
                                                         {1, 1, 1},
                                                         {-1, 1, 1}}};

Quadrature makeQuadrature() {
    const std::array<double, 3> abscissa{-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
    const std::array<double, 3> lineWeight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    Quadrature q;
    for (int g = 0; g < pointCount; ++g) {
        const std::array<int, 3> index{g % 3, g / 3 % 3, g / 9};
        q.weight[g] = lineWeight[index[0]] * lineWeight[index[1]] * lineWeight[index[2]];
        for (int a = 0; a < 8; ++a) {
            std::array<double, 3> factor;
            for (int i = 0; i < 3; ++i) {
                factor[i] = 0.5 * (1.0 + cornerSigns[a][i] * abscissa[index[i]]);
            }
            q.shape(a, g) = factor[0] * factor[1] * factor[2];
            q.gradient[g].row(a) << 0.5 * cornerSigns[a][0] * factor[1] * factor[2],
                0.5 * cornerSigns[a][1] * factor[0] * factor[2], 0.5 * cornerSigns[a][2] * factor[0] * factor[1];
        }
    }
    return q;
}

const Quadrature& quadrature() {
    static const Quadrature instance = makeQuadrature();
    return instance;
}

/// Determinants this small beside the largest one, or beside the cube of the size, are rounding.
constexpr double tangledTolerance = 1e-6;
constexpr double collapsedTolerance = 1e-12;

}  // namespace

const std::array<std::uint8_t, 8>& hexahedronCorners(ElementShape solid) {
    static constexpr std::array<std::uint8_t, 8> hexahedron{0, 1, 2, 3, 4, 5, 6, 7};
    static constexpr std::array<std::uint8_t, 8> wedge{0, 1, 2, 2, 3, 4, 5, 5};
    static constexpr std::array<std::uint8_t, 8> pyramid{0, 1, 2, 3, 4, 4, 4, 4};
    static constexpr std::array<std::uint8_t, 8> tetrahedron{0, 1, 2, 2, 3, 3, 3, 3};
    assert(isSolid(solid));
    switch (solid) {
        case ElementShape::Wedge:
            return wedge;
        case ElementShape::Pyramid:
            return pyramid;
        case ElementShape::Tetrahedron:
            return tetrahedron;
        default:
            return hexahedron;
    }
}

Corners asHexahedron(ElementShape solid, const Corners& own) {
    const auto& map = hexahedronCorners(solid);
    Corners all;
    for (int a = 0; a < 8; ++a) {
        all.col(a) = own.col(map[a]);
    }
    return all;
}

ConsistentMass consistentMass(const Corners& hexahedron, double mass) {
    const Quadrature& q = quadrature();
    Eigen::Matrix<double, pointCount, 1> measure;
    double least = 0.0;
    double most = 0.0;
    for (int g = 0; g < pointCount; ++g) {
        const Mat3 jacobian = hexahedron * q.gradient[g];
        const double determinant = jacobian.determinant();
        least = g == 0 ? determinant : std::min(least, determinant);
        most = g == 0 ? determinant : std::max(most, determinant);
        measure[g] = q.weight[g] * determinant;
    }
    ConsistentMass result;
    result.volume = measure.sum();
    const double size = (hexahedron.rowwise().maxCoeff() - hexahedron.rowwise().minCoeff()).maxCoeff();
    const double largest = std::max(std::abs(least), std::abs(most));
    if (!(largest > collapsedTolerance * size * size * size)) {
        result.state = SolidState::Collapsed;
        measure = q.weight;
    } else if (least < -tangledTolerance * largest) {
        result.state = most > tangledTolerance * largest ? SolidState::Tangled : SolidState::Mirrored;
    }
    const Eigen::Matrix<double, pointCount, 1> share = measure.cwiseAbs() * (mass / measure.cwiseAbs().sum());
    result.matrix.noalias() = q.shape * share.asDiagonal() * q.shape.transpose();
    return result;
}

Mat3 centreJacobian(const Corners& hexahedron) {
    Mat3 jacobian = Mat3::Zero();
    for (int a = 0; a < 8; ++a) {
        for (int i = 0; i < 3; ++i) {
            jacobian.col(i) += 0.125 * cornerSigns[a][i] * hexahedron.col(a);
        }
    }
    return jacobian;
}

}  // namespace rubble
