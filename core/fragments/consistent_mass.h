#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"

namespace rubble {

/// Positions (m) or velocities (m/s) of the corners of a solid, one column each. As a hexahedron all eight are used; wedges,
/// pyramids and tetrahedra are hexahedra with repeated corners, whose trilinear map is exactly their own interpolation.
using Corners = Eigen::Matrix<double, 3, 8>;

/// The solid's own corner that stands at each of the eight corners of a hexahedron (node order as in Exodus II and VTK).
const std::array<std::uint8_t, 8>& hexahedronCorners(ElementShape solid);

/// The corners of a solid spread over the eight corners of a hexahedron.
Corners asHexahedron(ElementShape solid, const Corners& own);

/// What the Jacobian determinants at the quadrature points say of a solid.
enum class SolidState : std::uint8_t {
    Sound,
    Mirrored,  ///< negative everywhere: the corners are numbered inside out
    Tangled,   ///< of both signs: folded through itself
    Collapsed  ///< no volume
};

/// Consistent mass of a solid: M_ab = integral of rho N_a N_b over its shape, with one rho for the element, scaled so that the sum
/// over all a, b is its mass. 3 x 3 x 3 Gauss points, exact for every trilinear hexahedron. Symmetric and positive semidefinite
/// whatever the shape: the weight is |det J|, and even over the parameter cube where there is no volume.
struct ConsistentMass {
    Eigen::Matrix<double, 8, 8> matrix;  ///< kg
    double volume = 0.0;                 ///< m3, signed integral of det J
    SolidState state = SolidState::Sound;
};

/// @param hexahedron  corner positions as asHexahedron() gives them, m, all finite
/// @param mass        kg
ConsistentMass consistentMass(const Corners& hexahedron, double mass);

/// dx/dxi at the middle of the parameter cube [-1, 1]^3, one column an axis (m).
Mat3 centreJacobian(const Corners& hexahedron);

}  // namespace rubble
