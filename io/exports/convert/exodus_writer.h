#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// Writes a result as one Exodus II file (netCDF-4, compressed), state by state: user's numbers, a block for each part and shape,
/// density, thickness and area as attributes, displacement disp_x, disp_y, disp_z and velocity vel_x, vel_y, vel_z at the nodes,
/// and for each element STATUS (1 is active) and, where it is known, death_time (0 stands for never). Blocks of one part have its
/// name; where a part needs several, the variable rubble_part tells which blocks belong together.
/// @param path    does not exist yet; what is there after an error is not whole
/// @param offset  added to all places, m
/// Throws WorldError, ParseError (a state cannot be read), Cancelled.
void writeExodus(const std::string& path, const FeResult& fe, const Vec3& offset, const Execution& execution);

}  // namespace rubble::io
