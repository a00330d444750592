#include "core/evidence/surveys/survey_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/evidence/maps/mark_distances.h"
#include "core/evidence/surveys/survey_measures.h"
#include "core/evidence/surveys/survey_registration.h"

namespace rubble {

namespace {

constexpr double reachShare = 0.95;  // of the covered area in a sector, within its run-out

void check(const SurveySettings& settings) {
    const auto size = [](double value) { return std::isfinite(value) && value >= 0.0; };
    if (!size(settings.leastHeight) || !size(settings.shiftMost) || !size(settings.liveThreshold) || settings.sectors < 1 ||
        settings.sectors > 360 || !size(settings.noise.value_or(0.0)) || !size(settings.groundNoise.value_or(0.0)) ||
        !size(settings.offsetError.value_or(0.0))) {
        throw UsageError({"survey.settings", "A setting of the survey comparison is no size", {}},
                         {"survey.settings.remedy", "Give lengths in metres, not below zero, and 1 to 360 sectors.", {}});
    }
}

/// Sums one side of a comparison cell by cell.
class SideSum {
public:
    SideSum(const Eigen::Vector2d& centre, const SurveySettings& settings, bool heights)
        : m_centre(centre),
          m_cell(settings.cell),
          m_heights(heights),
          m_turn(settings.turn),
          m_reach(static_cast<std::size_t>(settings.sectors)) {}

    /// @param height  m, of a cell that is covered
    void add(const Eigen::Vector2d& middle, double height) {
        const double area = m_cell * m_cell;
        const double weight = m_heights ? height * area : area;
        m_side.area += area;
        m_side.volume += height * area;
        m_weight += weight;
        m_side.centroid += weight * middle;
        const Eigen::Vector2d from = middle - m_centre;
        const auto sectors = static_cast<double>(m_reach.size());
        const double bearing = std::remainder(std::atan2(from.y(), from.x()) + m_turn, 2.0 * std::numbers::pi);
        const double turn = bearing / (2.0 * std::numbers::pi) * sectors + 0.5;
        const auto sector = static_cast<std::size_t>(std::floor(turn) + sectors) % m_reach.size();
        m_reach[sector].push_back(from.norm());
    }
    SurveySide side() {
        m_side.centroid = m_weight > 0.0 ? Eigen::Vector2d(m_side.centroid / m_weight) : Eigen::Vector2d(unknown, unknown);
        if (!m_heights) {
            m_side.volume = unknown;
        }
        for (std::vector<double>& distances : m_reach) {
            std::sort(distances.begin(), distances.end());
            const auto last = static_cast<std::size_t>(std::ceil(reachShare * static_cast<double>(distances.size())));
            m_side.runOut.push_back(distances.empty() ? 0.0 : distances[last - 1]);
        }
        return m_side;
    }

private:
    Eigen::Vector2d m_centre;
    double m_cell;
    bool m_heights;
    double m_weight = 0.0;
    double m_turn;                             // rad
    std::vector<std::vector<double>> m_reach;  ///< m, of covered cells [sectors]
    SurveySide m_side;
};

/// Goes over the cells that were surveyed.
void compareCells(SurveyComparison& made) {
    const CellGrid& debris = made.simulatedCells;
    const CellGrid& surveyed = made.surveyedCells;
    const SurveySettings& settings = made.settings;
    const bool heights = !made.isFootprint;
    SideSum survey(made.centre, settings, heights);
    SideSum simulated(made.centre, settings, heights);
    const double area = settings.cell * settings.cell;
    std::size_t both = 0;
    std::size_t either = 0;
    double squares = 0.0;
    double sum = 0.0;
    for (int row = 0; row < debris.rows; ++row) {
        for (int column = 0; column < debris.columns; ++column) {
            const std::size_t k = debris.index(column, row);
            const bool there = simulatedDebris(made, k);
            if (made.compared[k] == 0) {
                continue;
            }
            if (std::isnan(surveyed.values[k])) {
                made.unsurveyedArea += there ? area : 0.0;
                made.unsurveyedVolume += there ? debris.values[k] * area : 0.0;
                continue;
            }
            const bool real = surveyedDebris(made, k);
            if (there) {
                simulated.add(debris.middle(column, row), debris.values[k]);
            }
            if (real) {
                survey.add(debris.middle(column, row), heights ? surveyed.values[k] : 0.0);
            }
            if (!there && !real) {
                continue;
            }
            ++either;
            both += there && real ? 1 : 0;
            const double left = there ? (heights ? debris.values[k] : 1.0) : 0.0;
            const double right = real ? (heights ? surveyed.values[k] : 1.0) : 0.0;
            made.difference.values[k] = left - right;
            squares += (left - right) * (left - right);
            sum += left - right;
        }
    }
    made.survey = survey.side();
    made.simulated = simulated.side();
    made.iou = either > 0 ? static_cast<double>(both) / static_cast<double>(either) : unknown;
    made.heightRms = heights && either > 0 ? std::sqrt(squares / static_cast<double>(either)) : unknown;
    made.heightMean = heights && either > 0 ? sum / static_cast<double>(either) : unknown;
    made.centroidDistance = (made.simulated.centroid - made.survey.centroid).norm();
}

/// Refuses a comparison of nothing.
void checkCells(const SurveyComparison& made, const CellGrid& surveyed) {
    const auto known = [](double value) { return !std::isnan(value); };
    if (std::none_of(surveyed.values.begin(), surveyed.values.end(), known)) {
        throw UsageError({"survey.elsewhere", "The survey covers no cell of the site", {}},
                         {"survey.elsewhere.remedy",
                          "Check the coordinate systems of survey and case, the origin of the frame and the control points.",
                          {}});
    }
    if (!made.settings.scope.whole() && made.leftOut.comparedArea == 0.0) {
        const auto [low, high] = made.settings.scope.area.bounds();
        const auto covers = [&](std::size_t k) { return !std::isnan(surveyed.values[k]); };
        std::size_t cells = 0;
        for (std::size_t k = 0; k < surveyed.values.size(); ++k) {
            cells += covers(k) ? 1 : 0;
        }
        throw UsageError({"survey.area_elsewhere",
                          made.settings.scope.area.empty() ? "What is left out holds all {0} cells that were surveyed"
                                                           : "None of the {0} cells that were surveyed is compared: the area of "
                                                             "interest reaches from x = {1} to {2}, y = {3} to {4}",
                          {cells, low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}}},
                         {"survey.area_elsewhere.remedy",
                          "Check the coordinate systems of area, survey and case, the origin of the frame and the control points.",
                          {}});
    }
}

void findFlaws(SurveyComparison& made) {
    if (!made.settings.scope.whole() && made.simulated.area == 0.0 && made.leftOut.simulatedArea > 0.0) {
        made.findings.add(
            {"survey.area_misses",
             "all {0} of simulated debris lie outside of what is compared",
             {{made.leftOut.simulatedArea, "m2"}}},
            {"survey.area_misses.remedy", "check the area of interest, its coordinate system and that of the case", {}});
    }
    if (made.unsurveyedArea > 0.01 * (made.simulated.area + made.unsurveyedArea)) {
        made.findings.add({"survey.beyond",
                           "{0} of simulated debris lies where nothing was surveyed and is left out",
                           {{made.unsurveyedArea, "m2"}}},
                          {"survey.beyond.remedy", "take a survey of the whole site if that is not meant", {}});
    }
    if (made.shift.atLimit) {
        made.findings.add(
            {"survey.at_limit", "the best shift of the survey is as far as was looked: {0}", {{made.settings.shiftMost, "m"}}},
            {"survey.at_limit.remedy", "look at the place of the survey, or allow a longer shift", {}});
    }
    if (!made.shift.planKnown) {
        made.findings.add(
            {"survey.level", "the ground beside the debris is too level to find a shift in plan; only heights were moved", {}},
            {"survey.level.remedy", "make sure that the survey lies in the right place in plan", {}});
    }
}

/// What the two sides hold of live structure that fell.
Message wordsOf(const SurveyComparison& made) {
    const bool with = made.settings.withFallen;
    const Argument threshold{made.settings.liveThreshold, "m"};
    if (!made.surveyShowsFallen) {
        return with ? Message{"survey.words.with",
                              "The simulated side holds fallen live structure, what moved farther than {0}; whether the survey "
                              "does is "
                              "not known.",
                              {threshold}}
                    : Message{"survey.words.without",
                              "Fallen live structure is left out of the simulated side; whether the survey shows it is not known.",
                              {}};
    }
    if (with) {
        return *made.surveyShowsFallen
                   ? Message{"survey.words.both",
                             "Both sides hold fallen live structure: simulated, what moved farther than {0}.",
                             {threshold}}
                   : Message{"survey.words.simulated_only",
                             "The simulated side holds fallen live structure, what moved farther than {0}; the survey does not.",
                             {threshold}};
    }
    return *made.surveyShowsFallen ? Message{"survey.words.surveyed_only",
                                             "Fallen live structure is left out of the simulated side; the survey shows it.",
                                             {}}
                                   : Message{"survey.words.neither", "Both sides leave out fallen live structure.", {}};
}

/// Live structure that fell and that one side holds and the other does not, or may not.
void compareFallen(SurveyComparison& made, const std::string& survey) {
    const FallenStructure& fallen = made.fallen;
    const std::vector<Argument> amount{fallen.elements, {fallen.volume, "m3"}};
    if (fallen.elements > 0 && !made.surveyShowsFallen) {
        made.findings.add(
            {"survey.fallen_unknown",
             "live structure fell, {0} elements of {1}, and it is not known whether the survey shows such structure", amount},
            {"survey.fallen_unknown.remedy", "say what the survey shows (--survey-live)", {}}, survey, fallen.elements);
    } else if (fallen.elements > 0 && *made.surveyShowsFallen != made.settings.withFallen) {
        made.findings.add(
            made.settings.withFallen
                ? Message{"survey.fallen_simulated_only",
                          "fallen live structure counts as simulated debris, {0} elements of {1}, and the survey "
                          "does not hold such structure",
                          amount}
                : Message{"survey.fallen_surveyed_only",
                          "the survey shows fallen live structure, and that of the simulation, {0} elements of {1}, is "
                          "left out",
                          amount},
            {"survey.fallen.remedy", "count it on both sides or on neither (--live)", {}}, survey, fallen.elements);
    }
    if (fallen.held > 0 && made.surveyShowsFallen.value_or(true)) {
        made.findings.add({"survey.held",
                           "{0} loose parts of live structure were held where the FE result ends; in the survey they have fallen",
                           {fallen.held}},
                          {"survey.held.remedy", "set live_islands=released and simulate again", {}}, survey, fallen.held);
    }
}

/// Cells whose middle lies below or within one of the boxes [cells], 1 or 0.
std::vector<std::uint8_t> cellsUnder(const CellGrid& grid, std::span<const PlanBox> boxes) {
    std::vector<std::uint8_t> under(grid.values.size(), 0);
    const auto within = [&](double low, double high, int first, int count) {
        const double from = std::ceil(low / grid.cell - 0.5) - first;
        const double to = std::floor(high / grid.cell - 0.5) - first;
        return std::pair(static_cast<int>(std::clamp(from, 0.0, 1.0 * count)), static_cast<int>(std::clamp(to, -1.0, count - 1.0)));
    };
    for (const PlanBox& box : boxes) {
        const auto [left, right] = within(box.min().x(), box.max().x(), grid.low.i, grid.columns);
        const auto [below, above] = within(box.min().y(), box.max().y(), grid.low.j, grid.rows);
        for (int row = below; row <= above; ++row) {
            for (int column = left; column <= right; ++column) {
                under[grid.index(column, row)] = 1;
            }
        }
    }
    return under;
}

/// A survey of heights cannot tell a pier that stands from debris as high.
void compareStanding(SurveyComparison& made, std::span<const PlanBox> standing, const std::string& survey) {
    if (made.isFootprint || standing.empty()) {
        return;
    }
    constexpr double quiet = 0.01;  // of the surveyed debris
    const std::vector<std::uint8_t> under = cellsUnder(made.surveyedCells, standing);
    const double cellArea = made.surveyedCells.cell * made.surveyedCells.cell;
    for (std::size_t k = 0; k < under.size(); ++k) {
        if (under[k] != 0 && made.compared[k] != 0 && surveyedDebris(made, k)) {
            made.standing.area += cellArea;
            made.standing.volume += cellArea * made.surveyedCells.values[k];
        }
    }
    if (made.standing.area > quiet * made.survey.area) {
        made.findings.add(
            {"survey.standing",
             "structure stands in the run over {0} of the surveyed debris, with {1} of its volume: the survey most likely "
             "shows that structure, and it counts as debris on that side alone",
             {{made.standing.area, "m2"}, {made.standing.volume, "m3"}}},
            {"survey.standing.remedy", "draw an area of interest without it, or take it out of the survey", {}}, survey);
    }
}

/// Of each cell to the nearest simulated debris, in cells.
std::vector<double> distancesFromDebris(const SurveyComparison& made) {
    std::vector<std::uint8_t> marked(made.compared.size());
    for (std::size_t k = 0; k < marked.size(); ++k) {
        marked[k] = static_cast<std::uint8_t>(simulatedDebris(made, k));
    }
    return distancesTo(marked, made.difference.columns, made.difference.rows);
}

/// Says how well heights are known, and from where on they count.
void takeNoise(SurveyComparison& made, const Survey& survey, const std::vector<double>& distances) {
    if (survey.isFootprint || survey.heights.everywhere) {
        made.noise.source = survey.isFootprint ? SurveyNoise::Source::Unknown : SurveyNoise::Source::None;
        made.noise.offset = made.noise.correlation = unknown;
        return;
    }
    made.noise = noiseOf(made.surveyedCells, distances, made.settings.noise, made.settings.groundNoise);
    made.least = std::max(made.least, made.noise.detection());
}

}  // namespace

SurveyComparison compareWithSurvey(const PieceRaster& debris, const Survey& survey, const SiteSurface& ground,
                                   const Eigen::Vector2d& centre, const SurveySettings& settings, const Execution& execution,
                                   const FineDebris* fine) {
    check(settings);
    SurveyComparison made;
    made.isFootprint = survey.isFootprint;
    made.settings = settings;
    made.surveyShowsFallen = settings.showsFallen ? settings.showsFallen : survey.showsFallen;
    made.centre = centre;
    const CellGrid grid = gridAround(survey, debris, settings.cell, 2);
    made.difference = grid;
    made.simulatedCells = laidOn(grid, debris);
    made.compared = comparedOn(grid, settings.scope, execution);
    made.shift = registered(made.simulatedCells, made.compared, survey, ground, settings, execution);
    made.surveyedCells = surveyedOn(grid, survey, ground, made.shift.by, execution);
    made.least = std::max(settings.leastHeight, 1e-9);
    const std::vector<double> distances = distancesFromDebris(made);
    takeNoise(made, survey, distances);
    made.leftOut = leftOutOf(made, made.surveyedCells);
    checkCells(made, made.surveyedCells);
    for (std::size_t k = 0; k < made.compared.size(); ++k) {
        if (made.compared[k] == 0) {
            made.surveyedCells.values[k] = unknown;
        }
    }
    compareCells(made);
    if (!survey.isFootprint) {
        made.volumes = volumesOf(made);
    }
    made.apart = apartDebris(made, distances);
    if (fine != nullptr) {
        made.seen = seenMeasures(made, seenOn(grid, survey, *fine, settings.leastHeight, made.shift.by, execution));
    }
    findFlaws(made);
    findInMeasures(made, survey.name);
    made.words = wordsOf(made);
    return made;
}

SurveyComparison compareRunWithSurvey(const MappedRun& run, std::optional<double> time, const Survey& survey,
                                      const SurveySettings& settings, const Execution& execution) {
    check(settings);
    MapSettings map;
    map.cell = settings.cell;
    map.liveThreshold = settings.liveThreshold;
    const RunMap made = mapOfRun(run, time, map, true, execution);
    std::vector<MapPiece> pieces = mapPieces(*run.fragments, made.debris, made.arrivals, made.energies);
    if (settings.withFallen) {
        pieces.insert(pieces.end(), made.live->pieces.begin(), made.live->pieces.end());
    }
    const SiteSurface ground = groundOf(run);
    Aabb plan;
    for (const Vec3& node : run.fe->mesh().nodes) {
        if (node.allFinite()) {
            plan.extend(node);
        }
    }
    const PieceRaster debris = rasterOf(pieces, settings.cell, ground, execution);
    const double area = static_cast<double>(debris.cells.size()) * settings.cell * settings.cell;
    FineDebris fine;
    fine.cell = fineCellFor(survey, settings.cell, area);
    fine.raster = rasterOf(pieces, fine.cell, ground, execution);
    SurveyComparison compared = compareWithSurvey(debris, survey, ground, plan.center().head<2>(), settings, execution, &fine);
    compared.time = made.map.time;
    compared.shown = made.shown;
    compared.fallen = {static_cast<std::int64_t>(made.live->pieces.size()), made.live->volume,
                       run.result ? run.result->islands.held() : 0};
    compareFallen(compared, survey.name);
    if (!survey.heights.everywhere) {  // a debris map knows its debris from structure
        compareStanding(compared, made.live->standing, survey.name);
    }
    return compared;
}

bool surveyedDebris(const SurveyComparison& made, std::size_t cell) {
    return made.surveyedCells.values[cell] >= (made.isFootprint ? 0.5 : made.least);
}

bool simulatedDebris(const SurveyComparison& made, std::size_t cell) {
    return made.simulatedCells.values[cell] >= made.least;
}

std::string sectorName(int sector, int sectors) {
    static constexpr std::array<const char*, 8> names{"E", "NE", "N", "NW", "W", "SW", "S", "SE"};
    if (sectors == 8) {
        return names[static_cast<std::size_t>(sector)];
    }
    const double bearing = std::fmod(450.0 - 360.0 * sector / sectors, 360.0);
    return std::to_string(static_cast<int>(std::lround(bearing))) + " deg";
}

}  // namespace rubble
