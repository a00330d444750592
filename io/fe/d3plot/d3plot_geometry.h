#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "io/fe/d3plot/d3plot_header.h"

namespace rubble::io {

/// Elements of one kind as the file has them: nodes and parts are places from 0, not user's numbers.
struct D3plotElements {
    std::vector<std::int64_t> nodes;  ///< [elements x width]
    std::vector<std::int64_t> part;   ///< [elements]
    std::vector<std::int64_t> ids;    ///< user's numbers [elements]

    std::size_t count() const { return part.size(); }
};

/// Everything of a family that stands before its states.
struct D3plotGeometry {
    std::vector<Vec3> nodes;                      ///< at rest, file unit
    std::vector<std::int64_t> nodeIds;            ///< user's numbers
    D3plotElements solids, thickShells, shells;   ///< 8, 8 and 4 nodes
    D3plotElements beams;                         ///< 2 nodes
    D3plotElements particles;                     ///< 1 node
    std::vector<std::int64_t> partIds;            ///< user's numbers, by internal part; need not be unique
    std::vector<std::string> partTitles;          ///< by internal part, empty where there is none
    std::vector<bool> rigid;                      ///< by internal part, where the file says
    std::int64_t rigidShells = 0;                 ///< shells without values in the states
    std::int64_t particleWords = 0;               ///< values of a particle in a state
    std::int64_t particleDensity = -1;            ///< place of the density among them, -1 if it is not written
    std::int64_t airbagWords = 0, roadWords = 0;  ///< of a state
    std::int64_t end = 0;                         ///< first word of the states, or behind the last file
    Findings findings;
};

/// Reads geometry, numbers and titles. Throws ParseError for a family that ends before its geometry does, and for nodes and parts
/// that do not exist.
D3plotGeometry readD3plotGeometry(const D3plotFamily& family, const D3plotHeader& header, const Execution& execution);

/// Whether a word is the end mark that stands after the geometry and after the last state of a file.
bool isEndMark(double word);

}  // namespace rubble::io
