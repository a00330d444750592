#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Describes a small Exodus file and writes it with the Exodus library itself. All indices 0-based unless said.
struct ExodusBuilder {
    struct Block {
        int id = 1;
        std::string name;  ///< empty: unnamed
        std::string topology = "HEX8";
        int nodesPerElement = 8;
        std::vector<int> nodes;                     ///< 1-based, element by element
        std::vector<std::string> attributeNames{};  ///< may be fewer than attributes: the rest is unnamed
        std::vector<double> attributes{};           ///< [elements x attributes]
        int attributeCount = 0;

        int elements() const { return static_cast<int>(nodes.size()) / nodesPerElement; }
    };
    /// Value of a variable at a state for a node or for an element (position in the file).
    using Field = std::function<double(std::size_t state, std::size_t index)>;

    int dimensions = 3;
    std::vector<Vec3> nodes;
    std::vector<int> nodeNumbers;     ///< empty: no map
    std::vector<int> elementNumbers;  ///< empty: no map
    std::vector<Block> blocks;
    std::vector<double> times;
    std::vector<std::pair<std::string, Field>> nodal;
    std::vector<std::pair<std::string, Field>> element;
    std::vector<int> truthTable;  ///< [blocks x element variables]; empty: none is written and all blocks have all variables
    bool netcdf4 = false;
    std::string title = "fixture";

    /// Writes the file. Throws std::runtime_error with the call that failed.
    void write(const std::string& path) const;

    /// Adds `count` unit cubes in a row along x as one block; returns the position of the first in the file.
    std::size_t addCubes(int count, const std::string& name, int id);
    /// Adds disp_x, disp_y and disp_z, all zero.
    void addStillDisplacement();
    /// Three cubes, four states at 0, 0.5, 1, 1.5 s, still; the flag is added by the test.
    static ExodusBuilder threeCubes();
};

}  // namespace rubble::io
