#pragma once

#include <cstdint>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/exodus/exodus_file.h"
#include "io/fe/mesh_builder.h"

namespace rubble::io {

/// The mesh of an Exodus file and where its elements stand in the file: a run of elements for each block that was read.
struct ExodusMesh {
    Mesh mesh;
    std::vector<std::size_t> blocks;  ///< block of each run [runs]
    std::vector<std::size_t> first;   ///< first element of each run in the mesh [runs + 1]
    Findings findings;

    const Part& partOfRun(std::size_t run) const { return mesh.parts[mesh.part[first[run]]]; }
};

/// Reads coordinates, blocks and materials. Blocks that are no structure are left out and counted; solids numbered the other way
/// round at rest are turned and counted. Throws ParseError for files without elements, nodes that do not
/// exist and elements at nodes without a finite place.
ExodusMesh readExodusMesh(const ExodusFile& file);

}  // namespace rubble::io
