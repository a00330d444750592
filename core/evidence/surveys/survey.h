#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/evidence/maps/footprint.h"
#include "core/fe/height_grid.h"

namespace rubble {

/// Heights surveyed after the collapse.
struct SurveyHeights : HeightGrid {
    bool aboveGround = false;  ///< they count from the ground, and are means of cells around the nodes
    bool everywhere = false;   ///< where there is no height lies nothing; else nothing was surveyed there

    /// Between nodes by bilinear interpolation; not a number beyond the outermost nodes and beside a gap. Heights above the ground:
    /// that of the cell.
    double at(double x, double y) const;
};

/// What a surveyor measured of the real debris: heights, or only an outline.
struct Survey {
    std::string name;
    bool isFootprint = false;
    SurveyHeights heights;
    Outline footprint;
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
