#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/fe_result.h"

namespace rubble::render {

/// The edges of the structure as it stood at the first state: where its surface ends or turns by more than 30 degrees, and beams.
/// Two ends for each line, m, at rest.
/// @param hidden  [elements], 1 for those that are left out, or empty: none
std::vector<Eigen::Vector3f> intactOutline(const FeResult& fe, const std::vector<std::uint8_t>& hidden);

}  // namespace rubble::render
