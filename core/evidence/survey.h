#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Heights surveyed after the collapse, on a regular grid in the local frame; what has none is not a number.
struct SurveyHeights {
    double x0 = 0.0;  ///< m, first node
    double y0 = 0.0;
    double dx = 1.0;  ///< m, between nodes; positive
    double dy = 1.0;
    std::size_t nx = 0;
    std::size_t ny = 0;
    std::vector<double> heights;  ///< [ny * nx] m, row by row from the lowest y
    bool aboveGround = false;     ///< they count from the ground, and beyond the outermost nodes nothing lies on it

    /// Between nodes by bilinear interpolation; not a number beyond the outermost nodes and beside a gap. Heights above the ground
    /// are means of cells around the nodes: that of the cell.
    double at(double x, double y) const;
};

/// The outline of the real debris: rings in the local frame [m], a place within an odd number of them lies in it.
struct SurveyFootprint {
    std::vector<std::vector<Eigen::Vector2d>> rings;
};

/// What a surveyor measured of the real debris: heights, or only an outline.
struct Survey {
    std::string name;
    bool isFootprint = false;
    SurveyHeights heights;
    SurveyFootprint footprint;
    std::optional<bool> showsFallen;  ///< whether live structure that fell is in it; unset: the file does not say

    /// Box around what was surveyed, m.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
};

/// How the survey is moved before it is held against the debris.
enum class SurveyFit {
    None,    ///< it lies where it was surveyed
    Ground,  ///< to the ground beside the debris: errors of its place go, differences of the debris stay
    Debris,  ///< to the debris in plan: what then differs is the shape, no longer the place
};

}  // namespace rubble
