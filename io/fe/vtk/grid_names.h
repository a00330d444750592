#pragma once

#include <string>
#include <vector>

#include "core/scenario/scenario.h"
#include "io/fe/series/mesh_series.h"
#include "io/fe/vtk/grid.h"

namespace rubble::io {

/// Which arrays of a grid mean what; empty where there is none.
struct GridNames {
    SeriesFlag flag;
    bool ghostFlag = false;   ///< the flag is vtkGhostType, whose bits are looked at
    bool ghostNamed = false;  ///< because the settings say so
    std::string ghost;        ///< marks cells that are copies of another piece's
    std::string component;    ///< index into the names of components that the grid has
    std::string atRest;       ///< places of the nodes at rest
    std::string element, node, part, density, thickness, area, displacement, velocity;
    std::string deathTime;
};

/// Chooses by the usual names, whatever their case. @param grid  the first state with the names of all its arrays
/// Throws UsageError where the settings name an array that is not there; lists those that are.
GridNames chooseGridNames(const Grid& grid, const ImportSettings& settings, const std::string& path);

}  // namespace rubble::io
