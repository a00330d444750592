#pragma once

#include <cstdint>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/fe/d3plot/d3plot_geometry.h"

namespace rubble::io {

/// Where the values of a state stand, in words from its beginning.
struct D3plotStateLayout {
    std::int64_t coordinates = 0, velocities = 0;  ///< valid only where the header says that they are written
    std::int64_t solids = 0, thickShells = 0, beams = 0, shells = 0;
    std::int64_t deletion = 0;
    std::int64_t particles = 0;
    std::int64_t words = 0;  ///< of one state
};

/// Throws ParseError for a state longer than all files.
D3plotStateLayout layoutOfStates(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry);

/// The states of a family: where each begins and its time.
struct D3plotStates {
    std::vector<std::int64_t> begin;  ///< first word of each
    std::vector<double> times;        ///< as in the file, growing
    Findings findings;                ///< states cut off, written twice, abandoned or left over
};

/// Finds the states by their times alone; reads a few words of each. A state that is not complete ends the series.
D3plotStates findD3plotStates(const D3plotFamily& family, const D3plotGeometry& geometry, const D3plotStateLayout& layout,
                              const Execution& execution);

}  // namespace rubble::io
