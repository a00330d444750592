#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fe/mesh.h"

namespace rubble::io {

/// A variable of ours [blocks]: which blocks make one part. Files without it have a part a block.
inline constexpr const char* exodusPartVariable = "rubble_part";

/// Shape of a block's elements by its topology word and node count; nothing for blocks that are no structure (spheres, polygons).
/// Higher orders are known by their corners, which come first.
std::optional<ElementShape> shapeOf(std::string_view topology, std::int64_t nodesPerElement);

/// Three variables that make a vector, as indices into the list of names.
struct VectorVariable {
    std::string name;  ///< "disp_x, disp_y, disp_z"
    std::array<int, 3> index{};
};

/// Finds a vector by its prefix, whatever the case and the separator: "disp" finds disp_x, DISPX, Disp-X and so on.
std::optional<VectorVariable> findVector(const std::vector<std::string>& names, std::string_view prefix);
/// Finds the displacement (disp, displ, displacement, u) or the velocity (vel, velocity, v) by the usual prefixes.
std::optional<VectorVariable> findDisplacement(const std::vector<std::string>& names);
std::optional<VectorVariable> findVelocity(const std::vector<std::string>& names);

/// The active flag: which element variable, and what its name says about the value of active elements.
struct StatusVariable {
    int index = 0;
    std::string name;
    std::optional<int> activeByName;  ///< nothing: the name does not tell
};

/// Finds the active flag. @param wanted  the user's word; empty: by the known names, in order of how sure they are
std::optional<StatusVariable> findStatus(const std::vector<std::string>& names, std::string_view wanted);

/// Index of the first of these (lower-case) names that is in the list, whatever the case; -1 if none is.
int findAny(const std::vector<std::string>& names, const std::vector<std::string_view>& known);

/// A name from a file as it can be shown: without trailing blanks, control characters and broken UTF-8 replaced.
std::string shownName(std::string_view raw);

}  // namespace rubble::io
