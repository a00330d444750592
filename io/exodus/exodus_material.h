#pragma once

#include "io/exodus/exodus_mesh.h"

namespace rubble::io {

/// Fills density and section of the mesh from the blocks' attributes, else from element variables at the first state (density,
/// thickness); NaN where the file says nothing. Densities in t/mm3 or kg/mm3 of a file in millimetres are recognised by their size,
/// converted and counted.
void readExodusMaterial(const ExodusFile& file, const FrameTransform& frame, ExodusMesh& mesh);

}  // namespace rubble::io
