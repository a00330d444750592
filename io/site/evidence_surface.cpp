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

void coverCells(SurfaceEvidence& evidence, const Survey& survey, const CellGrid& grid, const Execution& execution) {
    OutlineFill fill(survey.footprint);
    for (int row = 0; row < grid.rows; ++row) {
        execution.check();
        const std::int32_t j = grid.low.j + row;
        std::int32_t next = grid.low.i;  // that is not covered yet
        for (const auto& [from, to] : fill.within((j + 0.5) * grid.cell)) {
            const auto first = static_cast<std::int32_t>(std::ceil(from / grid.cell - 0.5));
            const auto end = static_cast<std::int32_t>(std::ceil(to / grid.cell - 0.5));
            for (next = std::max(next, first); next < end; ++next) {
                evidence.seen.cells.push_back({j, next});
            }
        }
    }
    evidence.seen.heights.assign(evidence.seen.cells.size(), 1.0F);
}

void liftCells(SurfaceEvidence& evidence, const Survey& survey, const CellGrid& grid, const SiteSurface& ground,
               const Execution& execution) {
    const CellGrid laid = surveyedOn(grid, survey, ground, Vec3::Zero(), execution);
    const double least = survey.heights.everywhere ? leastMapped : leastSurveyed;
    evidence.everywhere = survey.heights.everywhere;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const double height = laid.values[grid.index(column, row)];
            const MapCell at = grid.at(column, row);
            if (std::isfinite(height) && !evidence.everywhere) {
                evidence.looked.push_back(at);
            }
            if (height >= least) {
                evidence.seen.cells.push_back(at);
                evidence.seen.heights.push_back(static_cast<float>(height));
            }
        }
    }
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
    const auto counts = [&](const MapCell& cell) {
        return !std::binary_search(evidence.leftOut.begin(), evidence.leftOut.end(), cell) &&
               (evidence.everywhere || std::binary_search(evidence.looked.begin(), evidence.looked.end(), cell));
    };
    if (!scope.whole() && std::none_of(evidence.seen.cells.begin(), evidence.seen.cells.end(), counts)) {
        refuseContent({"evidence.area_misses",
                       "What is compared of {0} holds none of its {1} cells with debris",
                       {input.path, evidence.seen.cells.size()}},
                      "Check the area of interest and what is left out, their coordinate systems and that of the case.");
    }
}

}  // namespace

SurfaceEvidence surfaceEvidence(const SurveyInput& input, const SurveyScope& scope, double cell, const SiteSurface& ground,
                                const Execution& execution) {
    const Survey& survey = input.survey;
    const CellGrid grid = gridAround(survey, PieceRaster(), cell, 0);
    SurfaceEvidence evidence;
    evidence.name = survey.name;
    evidence.kind = survey.isFootprint ? EvidenceKind::Footprint : EvidenceKind::Heights;
    if (survey.isFootprint) {
        coverCells(evidence, survey, grid, execution);
        if (evidence.seen.cells.empty()) {
            refuseContent({"evidence.no_area", "The polygons of {0} cover no cell of {1}", {input.path, {cell, "m"}}},
                          "Check their coordinate system and that of the case, or choose smaller cells.");
        }
        narrow(evidence, scope, grid, execution);
        checkScope(evidence, input, scope);
        return evidence;
    }
    liftCells(evidence, survey, grid, ground, execution);
    if (evidence.seen.cells.empty()) {
        refuseContent(
            {"evidence.no_debris", "{0} shows no debris: no cell of {1} is higher than the ground", {input.path, {cell, "m"}}},
            "Check what its heights are measured from: height= is above the ground, surface= in the heights of the case.");
    }
    narrow(evidence, scope, grid, execution);
    checkScope(evidence, input, scope);
    return evidence;
}

}  // namespace rubble::io
