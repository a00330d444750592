#pragma once

#include <vector>

#include "core/fragments/consistent_mass.h"

namespace rubble {

/// Corners of an element, one column each [3 x 8]; columns beyond are zero.
inline Corners cornerColumns(const std::vector<Vec3>& corners) {
    Corners matrix = Corners::Zero();
    for (std::size_t a = 0; a < corners.size(); ++a) {
        matrix.col(static_cast<Eigen::Index>(a)) = corners[a];
    }
    return matrix;
}

}  // namespace rubble
