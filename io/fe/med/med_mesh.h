#pragma once

#include <cstdint>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/med/med_file.h"

namespace rubble::io {

/// The elements of a MED mesh and where each stands among the cells of the file.
struct MedElements {
    Mesh mesh;                        ///< nodes and parts of the whole mesh; elements that are kept
    std::vector<std::uint32_t> cell;  ///< place among all cells of the mesh, in the order of its blocks [elements]
};

/// Where the cells of each block begin among all cells of a mesh [blocks + 1].
std::vector<std::size_t> firstCells(const MedMesh& mesh);

/// Takes the elements of a structure: parts are the groups of the families. Left out and counted are cells of types that make no
/// fragment, and faces and edges of other cells, unless a field has values on them.
/// @param carries  which cells a field of elements has values on at some step [cells]
/// @param reached  nodes that the displacement reaches at some step [nodes]; empty: all
/// Throws ParseError for nodes that do not exist.
MedElements medElements(const MedMesh& mesh, const std::vector<bool>& carries, const std::vector<bool>& reached,
                        const std::string& path, Findings& findings);

}  // namespace rubble::io
