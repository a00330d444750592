#include "io/site/evidence_surface.h"

#include <algorithm>
#include <cmath>

#include "core/evidence/surveys/survey_grid.h"
#include "io/site/file_words.h"

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

}  // namespace

SurfaceEvidence surfaceEvidence(const SurveyInput& input, double cell, const SiteSurface& ground, const Execution& execution) {
    const Survey& survey = input.survey;
    // Nodes are middles: their cells reach half a step farther.
    const double half = survey.isFootprint ? 0.0 : 0.5 * std::max(survey.heights.dx, survey.heights.dy);
    const CellGrid grid = gridAround(survey, PieceRaster(), cell, static_cast<int>(std::min(std::ceil(half / cell), 1e6)));
    SurfaceEvidence evidence;
    evidence.name = survey.name;
    evidence.kind = survey.isFootprint ? EvidenceKind::Footprint : EvidenceKind::Heights;
    if (survey.isFootprint) {
        coverCells(evidence, survey, grid, execution);
        if (evidence.seen.cells.empty()) {
            refuseContent({"evidence.no_area", "The polygons of {0} cover no cell of {1}", {input.path, {cell, "m"}}},
                          "Check their coordinate system and that of the case, or choose smaller cells.");
        }
        return evidence;
    }
    liftCells(evidence, survey, grid, ground, execution);
    if (evidence.seen.cells.empty()) {
        refuseContent(
            {"evidence.no_debris", "{0} shows no debris: no cell of {1} is higher than the ground", {input.path, {cell, "m"}}},
            "Check what its heights are measured from: height= is above the ground, surface= in the heights of the case.");
    }
    return evidence;
}

}  // namespace rubble::io
