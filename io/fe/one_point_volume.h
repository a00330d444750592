#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Volume of a hexahedron as explicit solvers take it, by one point: 8 det J at its centre. Signed.
inline double onePointVolume(const std::vector<Vec3>& corners) {
    constexpr std::array<std::array<double, 3>, 8> sign{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    Mat3 jacobian = Mat3::Zero();
    for (std::size_t a = 0; a < sign.size(); ++a) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            jacobian.col(static_cast<Eigen::Index>(axis)) += 0.125 * sign[a][axis] * corners[a];
        }
    }
    return 8.0 * jacobian.determinant();
}

}  // namespace rubble::io
