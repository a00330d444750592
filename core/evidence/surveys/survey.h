#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/evidence/maps/footprint.h"
#include "core/fe/height_grid.h"
#include "core/fe/raster_lattice.h"
#include "core/scenario/evidence_settings.h"

namespace rubble {

/// Heights of a raster as its file has them: of a survey, or of the ground below it.
struct SurveyHeights : HeightGrid {
    /// Set: the raster is turned or projected. Its columns and rows are those of this lattice, its first node is 0 and its step 1.
    std::optional<RasterLattice> lattice;
    bool aboveGround = false;  ///< they count from the ground, and are means of cells around the nodes
    bool everywhere = false;   ///< where there is no height lies nothing; else nothing was surveyed there

    /// Between nodes by bilinear interpolation; not a number beyond the outermost nodes and beside a gap. Heights above the ground:
    /// that of the cell.
    double at(double x, double y) const;
    /// m, local, of a column and row; not a number where that has no place.
    Eigen::Vector2d placeOf(double column, double row) const;
    /// m, longer side of what a height stands for; of a turned raster the shorter one.
    double spacing() const { return lattice ? lattice->pixel : std::max(dx, dy); }
    /// Least and greatest place, m.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
};

/// What a surveyor measured of the real debris: heights, or only an outline.
struct Survey {
    std::string name;
    bool isFootprint = false;
    SurveyHeights heights;
    /// The file of the terrain that debris fell on, as the survey is read: heights are then taken above it by one rule. Unset: they
    /// are taken above the nodes of that terrain.
    std::optional<SurveyHeights> ground;
    Outline footprint;
    bool reached = false;             ///< the outline holds each cell that debris reaches into, as one of our own maps does
    std::optional<bool> showsFallen;  ///< whether live structure that fell is in it; unset: the file does not say

    /// Box around what was surveyed, m.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
};

}  // namespace rubble
