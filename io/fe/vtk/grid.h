#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// Names of field data that say the time of a grid, the first known one first.
inline constexpr std::array<const char*, 4> gridTimeNames{"TimeValue", "TIME", "Time", "time"};

/// An array of values on points or cells.
struct GridArray {
    std::string name;
    std::size_t components = 1;
    std::vector<double> values;  ///< [entities x components]; empty where only the name was asked for
};

/// An unstructured grid as files of the VTK family hold it, in the file's units.
struct Grid {
    std::vector<Vec3> points;
    std::vector<std::uint8_t> types;         ///< VTK cell types [cells]
    std::vector<std::int64_t> offsets;       ///< first entry in connectivity [cells + 1]
    std::vector<std::int64_t> connectivity;  ///< points, 0-based, not yet checked
    std::vector<GridArray> pointData;
    std::vector<GridArray> cellData;
    std::vector<std::string> componentNames;  ///< of the field component_names; the cell array component indexes them
    std::optional<double> time;               ///< s, where the grid itself says it
    std::vector<MeshPiece> pieces;            ///< where each of several pieces ends (cells for elements); empty: it is one
    std::size_t storedCells = 0;              ///< in the file, whether or not cells were read
    bool vacant = false;                      ///< a piece without points and cells: a processor that had nothing

    std::size_t cellCount() const { return types.size(); }
};

/// What to read of a grid.
struct GridSelection {
    bool everything = false;  ///< all arrays with their values
    bool points = true;
    bool cells = true;
    std::vector<std::string> pointArrays;
    std::vector<std::string> cellArrays;

    bool wantsPoint(const std::string& name) const;
    bool wantsCell(const std::string& name) const;
};

/// The array of this name, nullptr if there is none.
const GridArray* findArray(const std::vector<GridArray>& arrays, const std::string& name);

/// Adds a grid behind another as a piece of its own: its points get their own positions. Point arrays that only one of them has are
/// dropped; cell arrays have no number where one lacks them. A vacant grid adds nothing.
void appendGrid(Grid& grid, const Grid& more);
/// The same where there may be no grid yet: the first one is taken as it is.
void joinGrid(std::optional<Grid>& grid, Grid more);

/// A series of grids, one a state. Implementations throw ParseError or WorldError naming the file.
class GridSource {
public:
    virtual ~GridSource() = default;
    virtual const std::vector<double>& times() const = 0;
    /// Reads state k; may be called from any thread.
    virtual Grid read(std::size_t k, const GridSelection& selection) const = 0;
    /// True where it is known without reading that state k has the points' numbers and the cells of state k - 1.
    /// @param cellArrays  cell arrays that must be unchanged as well
    virtual bool sameCells(std::size_t k, const std::vector<std::string>& cellArrays) const = 0;
};

}  // namespace rubble::io
