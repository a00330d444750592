#include "io/fe/vtk/grid.h"

#include <algorithm>
#include <utility>

#include "core/base/unknown.h"

namespace rubble::io {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void appendPointArrays(std::vector<GridArray>& arrays, const std::vector<GridArray>& more) {
    std::erase_if(arrays, [&](const GridArray& array) {
        const GridArray* other = findArray(more, array.name);
        return !other || other->components != array.components;
    });
    for (GridArray& array : arrays) {
        const std::vector<double>& values = findArray(more, array.name)->values;
        array.values.insert(array.values.end(), values.begin(), values.end());
    }
}

// Blocks that cannot fail often have no flag: what they lack is unknown, not the flag of the others.
void appendCellArrays(std::vector<GridArray>& arrays, std::size_t cells, const Grid& more) {
    for (const GridArray& array : more.cellData) {
        if (!findArray(arrays, array.name)) {
            GridArray& added = arrays.emplace_back(GridArray{array.name, array.components, {}});
            if (!array.values.empty()) {
                added.values.assign(cells * array.components, unknown);
            }
        }
    }
    std::erase_if(arrays, [&](const GridArray& array) {
        const GridArray* other = findArray(more.cellData, array.name);
        return other && other->components != array.components;
    });
    for (GridArray& array : arrays) {
        if (const GridArray* other = findArray(more.cellData, array.name)) {
            array.values.insert(array.values.end(), other->values.begin(), other->values.end());
        } else if (!array.values.empty()) {
            array.values.resize(array.values.size() + more.storedCells * array.components, unknown);
        }
    }
}

// Numbers of files are not checked yet: what overflows becomes one that nothing has.
std::int64_t shifted(std::int64_t value, std::int64_t by) {
    std::int64_t sum = 0;
    return __builtin_add_overflow(value, by, &sum) ? -1 : sum;
}

}  // namespace

bool GridSelection::wantsPoint(const std::string& name) const {
    return everything || contains(pointArrays, name);
}

bool GridSelection::wantsCell(const std::string& name) const {
    return everything || contains(cellArrays, name);
}

const GridArray* findArray(const std::vector<GridArray>& arrays, const std::string& name) {
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const GridArray& array) { return array.name == name; });
    return found == arrays.end() ? nullptr : &*found;
}

void appendGrid(Grid& grid, const Grid& more) {
    if (more.vacant) {
        return;
    }
    if (grid.vacant) {
        const std::optional<double> time = grid.time;
        grid = more;
        grid.time = time ? time : more.time;
        return;
    }
    const auto points = static_cast<std::int64_t>(grid.points.size());
    const auto first = static_cast<std::int64_t>(grid.connectivity.size());
    const MeshPiece before{grid.points.size(), grid.types.size()};
    if (grid.pieces.empty()) {
        grid.pieces.push_back(before);
    }
    appendPointArrays(grid.pointData, more.pointData);
    appendCellArrays(grid.cellData, grid.storedCells, more);
    grid.storedCells += more.storedCells;
    grid.points.insert(grid.points.end(), more.points.begin(), more.points.end());
    grid.types.insert(grid.types.end(), more.types.begin(), more.types.end());
    for (const std::int64_t point : more.connectivity) {
        grid.connectivity.push_back(shifted(point, points));
    }
    if (grid.offsets.empty()) {
        grid.offsets.push_back(0);
    }
    for (std::size_t c = 1; c < more.offsets.size(); ++c) {
        grid.offsets.push_back(shifted(more.offsets[c], first));
    }
    for (const MeshPiece& piece : more.pieces) {
        grid.pieces.push_back({before.nodes + piece.nodes, before.elements + piece.elements});
    }
    if (more.pieces.empty()) {
        grid.pieces.push_back({grid.points.size(), grid.types.size()});
    }
    if (!grid.time) {
        grid.time = more.time;
    }
}

void joinGrid(std::optional<Grid>& grid, Grid more) {
    if (grid) {
        appendGrid(*grid, more);
    } else {
        grid = std::move(more);
    }
}

}  // namespace rubble::io
