#include "core/evidence/ensembles/evidence_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/sequence.h"
#include "core/base/unknown.h"
#include "core/evidence/maps/mark_distances.h"
#include "core/evidence/surveys/survey_measures.h"
#include "core/evidence/surveys/survey_noise.h"

namespace rubble {

namespace {

constexpr double offsetLeast = 0.1;  // m, half of the height from which debris of a survey counts

/// The cells around what was seen with its heights, and how far each lies from the debris of all members.
struct SeenGrid {
    CellGrid heights;               ///< m; not a number where nothing was seen
    std::vector<double> distances;  ///< in cells
};

SeenGrid gridOfSeen(const SurfaceEvidence& evidence, std::span<const Hypothesis> hypotheses) {
    MapCell low = evidence.seen.cells.front();
    MapCell high = low;
    for (const MapCell& cell : evidence.seen.cells) {
        low = {std::min(low.j, cell.j), std::min(low.i, cell.i)};
        high = {std::max(high.j, cell.j), std::max(high.i, cell.i)};
    }
    SeenGrid grid;
    grid.heights.cell = hypotheses.front().ensemble->surface.cell;
    // Debris just beyond the survey lies near it too.
    const auto margin = static_cast<std::int32_t>(std::ceil(farFromDebris / grid.heights.cell)) + 2;
    grid.heights.low = {low.j - margin, low.i - margin};
    grid.heights.columns = high.i - low.i + 1 + 2 * margin;
    grid.heights.rows = high.j - low.j + 1 + 2 * margin;
    const auto count = static_cast<std::size_t>(grid.heights.columns) * static_cast<std::size_t>(grid.heights.rows);
    const auto place = [&](const MapCell& cell) {
        return grid.heights.index(cell.i - grid.heights.low.i, cell.j - grid.heights.low.j);
    };
    grid.heights.values.assign(count, unknown);
    for (std::size_t c = 0; c < evidence.seen.cells.size(); ++c) {
        grid.heights.values[place(evidence.seen.cells[c])] = double{evidence.seen.heights[c]};
    }
    std::vector<std::uint8_t> debris(count);
    for (const Hypothesis& hypothesis : hypotheses) {
        for (const EnsembleMember* member : hypothesis.ensemble->done()) {
            for (const MapCell& cell : member->surface->cells) {
                const bool within = cell.i >= grid.heights.low.i && cell.j >= grid.heights.low.j &&
                                    cell.i - grid.heights.low.i < grid.heights.columns &&
                                    cell.j - grid.heights.low.j < grid.heights.rows;
                if (within) {
                    debris[place(cell)] = 1;
                }
            }
        }
    }
    grid.distances = distancesTo(debris, grid.heights.columns, grid.heights.rows);
    return grid;
}

/// Of a normal distribution with a deviation of 1 (Box & Muller 1958), for one square of many.
double noiseOfSquare(std::uint64_t seed, std::int32_t j, std::int32_t i) {
    const auto part = [](std::int32_t place) { return std::uint64_t{static_cast<std::uint32_t>(place)}; };
    Sequence sequence(seed * 0x9e3779b97f4a7c15U + (part(j) << 32U | part(i)));
    const double first = 1.0 - sequence.between(0.0, 1.0);
    return std::sqrt(-2.0 * std::log(std::max(first, 1e-300))) * std::cos(2.0 * std::numbers::pi * sequence.between(0.0, 1.0));
}

void tellNoise(Findings& findings, const SurfaceEvidence& evidence, const SurveyNoise& noise) {
    if (noise.source == SurveyNoise::Source::Unknown) {
        findings.add({"evidence.noise_unknown",
                      "the noise of surveyed heights is not known: none is stated, and too few cells lie far from all debris; "
                      "heights count from {0} on",
                      {{evidence.least, "m"}}},
                     {"evidence.noise_unknown.remedy", "state the noise of the survey and of the ground in the case", {}},
                     evidence.name);
    } else {
        findings.add(
            noise.source == SurveyNoise::Source::Stated
                ? Message{"evidence.detection",
                          "heights count from {0} on; the level of detection (95 %) is {1}, of the stated noise of {2}",
                          {{evidence.least, "m"}, {noise.detection(), "m"}, {noise.deviation, "m"}}}
                : Message{"evidence.detection",
                          "heights count from {0} on; the level of detection (95 %) is {1}, of a noise of {2} estimated from {3} "
                          "cells far from all debris",
                          {{evidence.least, "m"}, {noise.detection(), "m"}, {noise.deviation, "m"}, noise.cells}},
            {"evidence.detection.remedy", "none is needed; what lies lower is taken for ground on both sides", {}}, evidence.name);
    }
    if (std::isfinite(noise.offset) && std::abs(noise.offset) > offsetLeast) {
        const std::vector<Argument> off{{std::abs(noise.offset), "m"}, noise.cells};
        findings.add(noise.offset > 0.0
                         ? Message{"evidence.offset",
                                   "far from all debris the survey lies {0} above the ground, in the median of {1} cells", off}
                         : Message{"evidence.offset",
                                   "far from all debris the survey lies {0} below the ground, in the median of {1} cells", off},
                     {"evidence.offset.remedy",
                      "check place, time, unit and vertical datum of the survey, or register it to the ground",
                      {}},
                     evidence.name);
    }
}

}  // namespace

CauseEvidence withDetection(const CauseEvidence& evidence, std::span<const Hypothesis> hypotheses, Findings& findings) {
    CauseEvidence held = evidence;
    for (SurfaceEvidence& surface : held.surfaces) {
        if (!surface.surveyed || surface.seen.cells.empty() || hypotheses.empty()) {
            continue;
        }
        const SeenGrid grid = gridOfSeen(surface, hypotheses);
        const SurveyNoise noise = noiseOf(grid.heights, grid.distances, surface.noise, surface.groundNoise);
        surface.least = std::max(surface.least, noise.detection());
        surface.found = noise;
        tellNoise(findings, surface, noise);
    }
    return held;
}

SurfaceEvidence surveyedAs(const MemberSurface& surface, const SurfaceEvidence& like, double cell, std::uint64_t seed) {
    if (!like.surveyed || !(like.found.deviation > 0.0)) {
        return seenAs(surface, like);
    }
    const double length = std::isfinite(like.found.correlation) ? like.found.correlation : 0.0;
    const double side = std::max(1.0, std::round(std::sqrt(2.0 * std::numbers::pi) * length / cell));  // cells
    SurfaceEvidence own = like;
    own.seen.heights.clear();
    for (const MapCell& at : own.seen.cells) {
        const std::ptrdiff_t lies = surface.find(at);
        const double height = lies >= 0 ? double{surface.heights[static_cast<std::size_t>(lies)]} : 0.0;
        const double noise = noiseOfSquare(seed, static_cast<std::int32_t>(std::floor(at.j / side)),
                                           static_cast<std::int32_t>(std::floor(at.i / side)));
        own.seen.heights.push_back(static_cast<float>(height + like.found.deviation * noise));
    }
    return own;
}

void findApart(Findings& findings, const SurfaceEvidence& evidence, std::span<const Hypothesis> hypotheses) {
    if (evidence.seen.cells.empty()) {
        return;
    }
    const SeenGrid grid = gridOfSeen(evidence, hypotheses);
    const double cell = grid.heights.cell;
    const double from = std::max(apartLeast, 2.0 * cell);
    const bool heights = evidence.kind == EvidenceKind::Heights;
    double all = 0.0;
    double apart = 0.0;
    for (std::size_t c = 0; c < evidence.seen.cells.size(); ++c) {
        const MapCell& at = evidence.seen.cells[c];
        if (!evidence.holds(evidence.seen, static_cast<std::ptrdiff_t>(c)) || !evidence.counts(at)) {
            continue;
        }
        const double amount = cell * cell * (heights ? double{evidence.seen.heights[c]} : 1.0);
        all += amount;
        const double distance = cell * grid.distances[grid.heights.index(at.i - grid.heights.low.i, at.j - grid.heights.low.j)];
        apart += distance > from ? amount : 0.0;
    }
    if (apart > apartShare * all) {
        findings.add({"causes.apart",
                      "{0} of {1} that were seen lie farther than {2} from the debris of every member of every hypothesis",
                      {{apart, heights ? "m3" : "m2"}, {all, heights ? "m3" : "m2"}, {from, "m"}}},
                     {"causes.apart.remedy",
                      "if that is no debris (vehicles, trees, houses), give an area of interest or leave it out; else no "
                      "hypothesis explains it",
                      {}},
                     evidence.name);
    }
}

}  // namespace rubble
