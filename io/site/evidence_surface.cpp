#include "io/site/evidence_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/evidence/surveys/survey_grid.h"
#include "io/base/file_words.h"

namespace rubble::io {

namespace {

/// m: less than this over the ground is no debris of a survey, but grass and noise; of a map of our own it is rounding.
constexpr double leastSurveyed = 0.05;
constexpr double leastMapped = 1e-6;

void coverCells(SurfaceEvidence& evidence, const CellGrid& laid) {
    for (int row = 0; row < laid.rows; ++row) {
        for (int column = 0; column < laid.columns; ++column) {
            if (laid.values[laid.index(column, row)] >= coveredLeast) {
                evidence.seen.cells.push_back(laid.at(column, row));
            }
        }
    }
    evidence.seen.heights.assign(evidence.seen.cells.size(), 1.0F);
    evidence.seen.covered.assign(evidence.seen.cells.size(), 1.0F);
}

/// Of a survey all that has a height was seen, for it tells the noise; of a map of our own what debris lies in.
void liftCells(SurfaceEvidence& evidence, const CellGrid& laid) {
    for (int row = 0; row < laid.rows; ++row) {
        for (int column = 0; column < laid.columns; ++column) {
            const double height = laid.values[laid.index(column, row)];
            if (std::isfinite(height) && (evidence.surveyed || height >= evidence.least)) {
                evidence.seen.cells.push_back(laid.at(column, row));
                evidence.seen.heights.push_back(static_cast<float>(height));
            }
        }
    }
    if (evidence.surveyed) {
        evidence.looked = evidence.seen.cells;
    }
}

/// @param thatCount  none else
std::size_t cellsWithDebris(const SurfaceEvidence& evidence, bool thatCount) {
    std::size_t cells = 0;
    for (std::size_t c = 0; c < evidence.seen.cells.size(); ++c) {
        const bool lies = evidence.holds(evidence.seen, static_cast<std::ptrdiff_t>(c));
        cells += lies && (!thatCount || evidence.counts(evidence.seen.cells[c])) ? 1 : 0;
    }
    return cells;
}

/// The cells that an outline holds, ascending. @param cell  m
std::vector<MapCell> cellsWithin(const Outline& outline, double cell, const Execution& execution) {
    Survey survey;
    survey.isFootprint = true;
    survey.footprint = outline;
    const CellGrid grid = gridAround(survey, PieceRaster(), cell, 0);
    const std::vector<std::uint8_t> within = comparedOn(grid, {outline, {}}, execution);
    std::vector<MapCell> cells;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (within[grid.index(column, row)] != 0) {
                cells.push_back(grid.at(column, row));
            }
        }
    }
    return cells;
}

/// Only what lies within the scope was looked at.
void narrow(SurfaceEvidence& evidence, const SurveyScope& scope, const CellGrid& grid, const Execution& execution) {
    if (!scope.area.empty()) {
        std::vector<MapCell> area = cellsWithin(scope.area, grid.cell, execution);
        if (!evidence.everywhere) {
            std::vector<MapCell> both;
            std::set_intersection(evidence.looked.begin(), evidence.looked.end(), area.begin(), area.end(),
                                  std::back_inserter(both));
            area = std::move(both);
        }
        evidence.everywhere = false;
        evidence.looked = std::move(area);
    }
    if (!scope.leftOut.empty()) {
        evidence.leftOut = cellsWithin(scope.leftOut, grid.cell, execution);
    }
}

/// Refuses a scope that nothing is seen in.
void checkScope(const SurfaceEvidence& evidence, const SurveyInput& input, const SurveyScope& scope) {
    if (!scope.whole() && cellsWithDebris(evidence, true) == 0) {
        refuseContent({"evidence.area_misses",
                       "What is compared of {0} holds none of its {1} cells with debris",
                       {input.path, cellsWithDebris(evidence, false)}},
                      "Check the area of interest and what is left out, their coordinate systems and that of the case.");
    }
}

}  // namespace

SurfaceEvidence surfaceEvidence(const SurveyInput& input, const CaseInput& stated, double cell, const SiteSurface& ground,
                                const Execution& execution) {
    const Survey& survey = input.survey;
    const CellGrid laid = surveyedOn(gridAround(survey, PieceRaster(), cell, 0), survey, ground, Vec3::Zero(), execution);
    SurfaceEvidence evidence;
    evidence.name = survey.name;
    if (survey.isFootprint) {
        evidence.kind = EvidenceKind::Footprint;
        evidence.reached = survey.reached;
        coverCells(evidence, laid);
        if (evidence.seen.cells.empty()) {
            refuseContent({"evidence.no_area", "The polygons of {0} cover no cell of {1}", {input.path, {cell, "m"}}},
                          "Check their coordinate system and that of the case, or choose smaller cells.");
        }
    } else {
        evidence.kind = EvidenceKind::Heights;
        evidence.everywhere = survey.heights.everywhere;
        evidence.surveyed = !survey.heights.everywhere;
        evidence.least = evidence.surveyed ? leastSurveyed : leastMapped;
        evidence.noise = stated.noise;
        evidence.groundNoise = stated.groundNoise;
        liftCells(evidence, laid);
        if (cellsWithDebris(evidence, false) == 0) {
            refuseContent(
                {"evidence.no_debris", "{0} shows no debris: no cell of {1} is higher than the ground", {input.path, {cell, "m"}}},
                "Check what its heights are measured from: height= is above the ground, surface= in the heights of the case.");
        }
    }
    narrow(evidence, stated.scope, laid, execution);
    checkScope(evidence, input, stated.scope);
    return evidence;
}

}  // namespace rubble::io
