#pragma once

#include <string>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/exodus/exodus_file.h"
#include "io/fe/mesh_builder.h"

namespace rubble::io {

/// Sets density and section of a block's elements from its attributes, else from element variables at the first state (density,
/// thickness); what the file does not say stays unknown.
/// @param part   named in findings  @param first  of the block's elements in the builder
void readExodusMaterial(const ExodusFile& file, std::size_t block, ElementShape shape, const std::string& part, std::size_t first,
                        MeshBuilder& builder, Findings& findings);

}  // namespace rubble::io
