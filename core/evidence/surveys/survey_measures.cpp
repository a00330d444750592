#include "core/evidence/surveys/survey_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr double rounding = 1e-6;  // m, of a height
constexpr double nowhere = 1e9;    // m

/// Overlap of two sets of cells over their union, of those that count.
class Overlap {
public:
    void add(bool first, bool second) {
        m_both += first && second ? 1 : 0;
        m_either += first || second ? 1 : 0;
    }
    double iou() const { return m_either > 0 ? static_cast<double>(m_both) / static_cast<double>(m_either) : unknown; }

private:
    std::int64_t m_both = 0;
    std::int64_t m_either = 0;
};

bool counts(const SurveyComparison& made, std::size_t cell) {
    return made.compared[cell] != 0 && !std::isnan(made.surveyedCells.values[cell]);
}

/// Collects the cells of one patch after the other, by sides and corners.
class Patches {
public:
    explicit Patches(const SurveyComparison& made) : m_made(made), m_taken(made.surveyedCells.values.size(), 0) {}

    /// The cells of the patch that a cell belongs to; empty: it was taken already, or no debris lies there.
    const std::vector<std::size_t>& patchOf(std::size_t cell) {
        m_cells.clear();
        take(cell);
        for (std::size_t next = 0; next < m_cells.size(); ++next) {
            const auto column = static_cast<int>(m_cells[next] % static_cast<std::size_t>(m_made.difference.columns));
            const auto row = static_cast<int>(m_cells[next] / static_cast<std::size_t>(m_made.difference.columns));
            for (int j = std::max(0, row - 1); j <= std::min(row + 1, m_made.difference.rows - 1); ++j) {
                for (int i = std::max(0, column - 1); i <= std::min(column + 1, m_made.difference.columns - 1); ++i) {
                    take(m_made.difference.index(i, j));
                }
            }
        }
        return m_cells;
    }

private:
    void take(std::size_t cell) {
        if (m_taken[cell] == 0 && counts(m_made, cell) && surveyedDebris(m_made, cell)) {
            m_taken[cell] = 1;
            m_cells.push_back(cell);
        }
    }

    const SurveyComparison& m_made;
    std::vector<std::uint8_t> m_taken;
    std::vector<std::size_t> m_cells;
};

}  // namespace

LeftOutDebris leftOutOf(const SurveyComparison& made, const CellGrid& surveyed) {
    LeftOutDebris left;
    const double area = made.settings.cell * made.settings.cell;
    for (std::size_t k = 0; k < made.compared.size(); ++k) {
        if (made.compared[k] != 0) {
            left.comparedArea += std::isnan(surveyed.values[k]) ? 0.0 : area;
            continue;
        }
        if (simulatedDebris(made, k)) {
            left.simulatedArea += area;
            left.simulatedVolume += made.simulatedCells.values[k] * area;
        }
        if (surveyed.values[k] >= (made.isFootprint ? 0.5 : made.least)) {
            left.surveyedArea += area;
            left.surveyedVolume += surveyed.values[k] * area;
        }
    }
    if (made.isFootprint) {
        left.surveyedVolume = unknown;
    }
    return left;
}

namespace {

/// Of the heights over an area that counts, m2.
VolumeError volumeError(const SurveyComparison& made, double counted) {
    constexpr double confidence = 1.96;
    const double cell = made.settings.cell * made.settings.cell;
    // Noise that hangs together does not average out over the area that it hangs together in.
    const double length = std::isfinite(made.noise.correlation) ? made.noise.correlation : 0.0;
    const double together = std::min(std::max(cell, 2.0 * std::numbers::pi * length * length), std::max(counted, cell));
    const bool known = made.noise.source == SurveyNoise::Source::Stated || made.noise.source == SurveyNoise::Source::Estimated;
    VolumeError error;
    error.random = known ? confidence * made.noise.deviation * std::sqrt(counted * together) : unknown;
    error.systematic = made.settings.offsetError ? confidence * *made.settings.offsetError * counted : unknown;
    return error;
}

}  // namespace

SurveyVolumes volumesOf(const SurveyComparison& made) {
    SurveyVolumes volumes;
    const double area = made.settings.cell * made.settings.cell;
    const double detection = std::max(made.noise.detection(), rounding);
    double filled = 0.0;
    double cut = 0.0;
    for (std::size_t k = 0; k < made.compared.size(); ++k) {
        if (!counts(made, k)) {
            continue;
        }
        const double height = made.surveyedCells.values[k];
        if (std::abs(height) < detection) {
            (height > 0.0 ? volumes.undetectedFill : volumes.undetectedCut) += std::abs(height) * area;
            continue;
        }
        (height > 0.0 ? volumes.fill : volumes.cut) += std::abs(height) * area;
        (height > 0.0 ? filled : cut) += area;
    }
    volumes.fillError = volumeError(made, filled);
    volumes.cutError = volumeError(made, cut);
    volumes.netError = volumeError(made, filled + cut);
    return volumes;
}

ApartDebris apartDebris(const SurveyComparison& made, const std::vector<double>& distances) {
    ApartDebris apart;
    apart.nearest = std::numeric_limits<double>::infinity();
    const double cell = made.settings.cell;
    const double from = std::max(apartLeast, 2.0 * cell);
    double largest = 0.0;
    Patches patches(made);
    for (std::size_t k = 0; k < made.compared.size(); ++k) {
        const std::vector<std::size_t>& patch = patches.patchOf(k);
        double nearest = std::numeric_limits<double>::infinity();
        double farthest = 0.0;
        double volume = 0.0;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const std::size_t at : patch) {
            nearest = std::min(nearest, cell * distances[at]);
            farthest = std::max(farthest, cell * distances[at]);
            volume += made.surveyedCells.values[at] * cell * cell;
            sum += made.difference.middle(static_cast<int>(at % static_cast<std::size_t>(made.difference.columns)),
                                          static_cast<int>(at / static_cast<std::size_t>(made.difference.columns)));
        }
        // Without any simulated debris nothing is apart from it.
        if (patch.empty() || nearest <= from || nearest > nowhere) {
            continue;
        }
        ++apart.patches;
        apart.area += static_cast<double>(patch.size()) * cell * cell;
        apart.volume += volume;
        apart.nearest = std::min(apart.nearest, nearest);
        apart.farthest = std::max(apart.farthest, farthest);
        if (volume > largest) {
            largest = volume;
            apart.largest = sum / static_cast<double>(patch.size());
        }
    }
    return apart.patches > 0 ? apart : ApartDebris{};
}

SeenDebris seenMeasures(const SurveyComparison& made, const CellGrid& seen) {
    SeenDebris measures;
    const double area = made.settings.cell * made.settings.cell;
    const double least = made.isFootprint ? 0.5 : made.least;
    Overlap reachable;
    Overlap alike;
    for (std::size_t k = 0; k < made.compared.size(); ++k) {
        if (!counts(made, k)) {
            continue;
        }
        const bool shown = seen.values[k] >= least;
        if (shown) {
            measures.area += area;
            measures.volume += seen.values[k] * area;
        }
        reachable.add(shown, simulatedDebris(made, k));
        alike.add(shown, surveyedDebris(made, k));
    }
    if (made.isFootprint) {
        measures.volume = unknown;
    }
    measures.reachableIou = reachable.iou();
    measures.alikeIou = alike.iou();
    return measures;
}

void findInMeasures(SurveyComparison& made, const std::string& survey) {
    const SurveyNoise& noise = made.noise;
    if (made.least > made.settings.leastHeight) {
        made.findings.add({"survey.detection",
                           "heights count from {0} on, the level of detection, and not from the least height of {1}: what lies "
                           "lower may be noise",
                           {{noise.detection(), "m"}, {made.settings.leastHeight, "m"}}},
                          {"survey.detection.remedy",
                           "state the noise of survey and ground if it is less, or register the survey to the ground",
                           {}},
                          survey);
    }
    if (std::isfinite(noise.offset) && std::abs(noise.offset) > 0.5 * std::max(made.settings.leastHeight, 0.02)) {
        const std::vector<Argument> off{{std::abs(noise.offset), "m"}, noise.cells};
        made.findings.add(
            noise.offset > 0.0
                ? Message{"survey.offset",
                          "far from all simulated debris the survey lies {0} above the ground, in the median of {1} cells", off}
                : Message{"survey.offset",
                          "far from all simulated debris the survey lies {0} below the ground, in the median of {1} cells", off},
            {"survey.offset.remedy", "check place, time, unit and vertical datum of the survey, or register it to the ground", {}},
            survey);
    }
    const ApartDebris& apart = made.apart;
    const bool much =
        made.isFootprint ? apart.area > apartShare * made.survey.area : apart.volume > apartShare * made.survey.volume;
    if (apart.patches > 0 && much) {
        const std::vector<Argument> place{
            {apart.nearest, "m"}, {apart.farthest, "m"}, apart.patches, apart.largest.x(), {apart.largest.y(), "m"}};
        std::vector<Argument> all{made.isFootprint ? Argument(apart.area, "m2") : Argument(apart.volume, "m3")};
        all.insert(all.end(), place.begin(), place.end());
        made.findings.add(
            {"survey.apart",
             "{0} of what was surveyed lie apart from all simulated debris, {1} to {2} away, in {3} places; the largest is "
             "around x = {4}, y = {5}",
             all},
            {"survey.apart.remedy",
             "if that is no debris (vehicles, trees, houses), give an area of interest or leave it out (--area, --leave-out)",
             {}},
            survey, apart.patches);
    }
}

}  // namespace rubble
