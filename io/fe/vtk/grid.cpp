#include "io/fe/vtk/grid.h"

#include <algorithm>

namespace rubble::io {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void appendArrays(std::vector<GridArray>& arrays, const std::vector<GridArray>& more) {
    std::erase_if(arrays, [&](const GridArray& array) {
        const GridArray* other = findArray(more, array.name);
        return !other || other->components != array.components;
    });
    for (GridArray& array : arrays) {
        const std::vector<double>& values = findArray(more, array.name)->values;
        array.values.insert(array.values.end(), values.begin(), values.end());
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
    const auto points = static_cast<std::int64_t>(grid.points.size());
    const auto first = static_cast<std::int64_t>(grid.connectivity.size());
    appendArrays(grid.pointData, more.pointData);
    appendArrays(grid.cellData, more.cellData);
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
    if (!grid.time) {
        grid.time = more.time;
    }
}

}  // namespace rubble::io
