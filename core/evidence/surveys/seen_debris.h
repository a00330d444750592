#pragma once

#include "core/evidence/surveys/survey_grid.h"

namespace rubble {

/// Heights of debris on cells so fine that a survey's own cells can be filled from them.
struct FineDebris {
    PieceRaster raster;
    double cell = 0.0;  ///< m
};

/// Side of the cells that debris is laid on to be seen as a survey sees it, m: a fifth of what a height of the survey stands for,
/// or more where that would be too many cells.
/// @param area  m2, of the debris
double fineCellFor(const Survey& survey, double cell, double area);

/// The simulated debris as the survey would have shown it: its heights taken where the survey has heights (of an outline: the
/// shares of cells that it covers), and laid on the grid as surveyedOn() lays the survey.
CellGrid seenOn(const CellGrid& grid, const Survey& survey, const FineDebris& debris, double leastHeight, const Vec3& shift,
                const Execution& execution);

}  // namespace rubble
