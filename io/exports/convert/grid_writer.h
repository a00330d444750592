#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// Writes a result as a series for ParaView: NAME.pvd and a folder NAME with one state_NNNNN.vtu for each state. Points are where
/// the nodes are; cells are all elements, with STATUS (1 is active), the dead hidden by vtkGhostType, ELEMENT_ID, component (an
/// index into the field component_names), PART_ID, density, thickness and area where known, death_time where known; points have
/// NODE_ID, initial_position and velocity where there is one. The folder and then the index come into place when all is written;
/// with `replace` they take the place of an earlier series, never of anything else.
/// @param path    of the index, ends in .pvd
/// @param offset  added to all places, m
/// Throws WorldError, ParseError (a state cannot be read), Cancelled.
void writeGridSeries(const std::string& path, const FeResult& fe, const Vec3& offset, bool replace, const Execution& execution);

/// The folder that belongs to an index.
std::string gridFolder(const std::string& path);

}  // namespace rubble::io
