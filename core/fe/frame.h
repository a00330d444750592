#pragma once

#include <cstdint>
#include <string>

#include "core/base/geometry.h"

namespace rubble {

/// How the local coordinates of a case relate to the outside world. Core is local; io applies the frame in and out.
struct Frame {
    Eigen::Matrix<std::int64_t, 3, 1> origin =
        Eigen::Matrix<std::int64_t, 3, 1>::Zero();  ///< local origin in file coordinates, whole metres
    double metresPerUnit = 1.0;                     ///< length unit of the file
    std::string upAxis = "z";                       ///< axis of the file that points up: x, y, z, -x, -y or -z
    std::string crs;                                ///< coordinate reference system, empty if none is known

    friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace rubble
