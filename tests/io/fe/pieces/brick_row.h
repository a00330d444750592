#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// Unit bricks in a row along x as a VTU file, from one place on; every brick is an element.
struct BrickRow {
    std::vector<int> bricks{};              ///< places of the bricks that are there, by x
    bool ownPoints = false;                 ///< each brick has points of its own
    std::vector<int> status{};              ///< [bricks]; empty: none is written
    std::vector<int> ghosts{};              ///< vtkGhostType [bricks]; empty: none is written
    std::vector<std::int64_t> elements{};   ///< ELEMENT_ID [bricks]; empty: none is written
    std::optional<std::int64_t> nodesBy{};  ///< NODE_ID: 4 x + corner + this; nothing: none is written
    double liftFrom = 1e9;                  ///< bricks from this x on are lifted by 0.5 m
    std::optional<double> time{};           ///< TimeValue

    std::string vtu() const;
};

/// An index of pieces.
std::string pvtu(const std::vector<std::string>& pieces);
/// Lines "timestep part file" of an index of times; one without a timestep has an empty one.
std::string pvd(const std::vector<std::vector<std::string>>& lines);

}  // namespace rubble::io
