#include "core/evidence/surveys/survey_registration.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

/// Mean squared difference of two grids where the survey has a number and either has debris.
struct Misfit {
    double sum = 0.0;
    std::size_t cells = 0;
    double mean() const { return cells > 0 ? sum / static_cast<double>(cells) : 0.0; }
};

/// What counts of a cell when debris is fitted: height, or whether it is covered.
double counted(double value, bool covered, const SurveySettings& settings) {
    return covered ? (value >= settings.leastHeight ? 1.0 : 0.0) : value >= settings.leastHeight ? value : 0.0;
}

/// What the shift of a survey is found from.
struct Fitted {
    const CellGrid& debris;
    const std::vector<std::uint8_t>& compared;  ///< [cells] that count
    const Survey& survey;
    const SiteSurface& ground;
    const SurveySettings& settings;
};

/// Squares are taken over all cells that are compared: a survey moved away from the debris finds no smaller sum.
Misfit misfitMoved(const Fitted& fitted, const CellGrid& survey, int di, int dj) {
    const CellGrid& debris = fitted.debris;
    const SurveySettings& settings = fitted.settings;
    const bool footprint = fitted.survey.isFootprint;
    Misfit misfit;
    for (int row = 0; row < debris.rows; ++row) {
        const int fromRow = row - dj;
        for (int column = 0; column < debris.columns; ++column) {
            if (fitted.compared[debris.index(column, row)] == 0) {
                continue;
            }
            const int from = column - di;
            const bool inside = fromRow >= 0 && from >= 0 && fromRow < survey.rows && from < survey.columns;
            const double there = inside ? survey.values[survey.index(from, fromRow)] : std::nan("");
            const double surveyed = std::isnan(there) ? 0.0 : footprint ? there : counted(there, false, settings);
            const double simulated = counted(debris.values[debris.index(column, row)], footprint, settings);
            if (surveyed != 0.0 || simulated != 0.0) {
                misfit.sum += (simulated - surveyed) * (simulated - surveyed);
                ++misfit.cells;
            }
        }
    }
    return misfit;
}

/// Where a parabola through three equally spaced values is least, in steps from the middle one.
double least(double before, double middle, double after) {
    const double bend = before - 2.0 * middle + after;
    return bend > 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

SurveyShift toDebris(const Fitted& fitted, const Execution& execution) {
    const CellGrid& debris = fitted.debris;
    const CellGrid laid = surveyedOn(debris, fitted.survey, fitted.ground, Vec3::Zero(), execution);
    const int reach = static_cast<int>(std::floor(fitted.settings.shiftMost / debris.cell + 1e-9));
    const int side = 2 * reach + 1;
    std::vector<double> sums(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    const auto at = [&](int i, int j) -> double& {
        return sums[static_cast<std::size_t>(j + reach) * static_cast<std::size_t>(side) + static_cast<std::size_t>(i + reach)];
    };
    int bestI = 0;
    int bestJ = 0;
    Misfit still;
    Misfit best;
    for (int j = -reach; j <= reach; ++j) {
        execution.check();
        for (int i = -reach; i <= reach; ++i) {
            const Misfit moved = misfitMoved(fitted, laid, i, j);
            at(i, j) = moved.sum;
            if (i == 0 && j == 0) {
                still = moved;
            }
            if (best.cells == 0 || moved.sum < best.sum) {
                best = moved;
                bestI = i;
                bestJ = j;
            }
        }
    }
    if (best.cells == 0) {
        throw UsageError({"survey.no_debris", "Neither the survey nor the simulation has debris to fit to", {}},
                         {"survey.no_debris.remedy", "Lower the least height, or compare without registration.", {}});
    }
    SurveyShift shift;
    shift.atLimit = reach > 0 && (std::abs(bestI) == reach || std::abs(bestJ) == reach);
    double x = bestI;
    double y = bestJ;
    if (reach > 0 && !shift.atLimit) {
        x += least(at(bestI - 1, bestJ), best.sum, at(bestI + 1, bestJ));
        y += least(at(bestI, bestJ - 1), best.sum, at(bestI, bestJ + 1));
    }
    shift.by = {x * debris.cell, y * debris.cell, 0.0};
    shift.cells = best.cells;
    const CellGrid moved = surveyedOn(debris, fitted.survey, fitted.ground, shift.by, execution);
    shift.before = std::sqrt(still.mean());
    shift.after = std::sqrt(misfitMoved(fitted, moved, 0, 0).mean());
    return shift;
}

/// Cells beside the debris: what the survey shows there is ground.
struct GroundCell {
    Eigen::Vector2d middle;
    double residual = 0.0;  ///< m, surveyed less ground
    Eigen::Vector3d row;    ///< change of the residual by a shift of the survey along x, y, z
};

/// @param usable  [cells] that are not left out
std::vector<GroundCell> groundCells(const Fitted& fitted, const std::vector<std::uint8_t>& usable, const Vec3& shift) {
    std::vector<GroundCell> cells;
    const CellGrid& debris = fitted.debris;
    const SurveyHeights& heights = fitted.survey.heights;
    for (int row = 1; row + 1 < debris.rows; ++row) {
        for (int column = 1; column + 1 < debris.columns; ++column) {
            bool beside = usable[debris.index(column, row)] != 0;
            for (int j = -1; j <= 1 && beside; ++j) {
                for (int i = -1; i <= 1; ++i) {
                    beside = beside && debris.values[debris.index(column + i, row + j)] == 0.0;
                }
            }
            const Eigen::Vector2d p = debris.middle(column, row);
            const double x = p.x() - shift.x();
            const double y = p.y() - shift.y();
            const double h = debris.cell;
            const double residual = heights.at(x, y) + shift.z() - groundBelow(fitted.survey, fitted.ground, p.x(), p.y());
            const double alongX = (heights.at(x + h, y) - heights.at(x - h, y)) / (2.0 * h);
            const double alongY = (heights.at(x, y + h) - heights.at(x, y - h)) / (2.0 * h);
            if (beside && std::isfinite(residual + alongX + alongY)) {
                cells.push_back({p, residual, {-alongX, -alongY, 1.0}});
            }
        }
    }
    return cells;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Cells whose residual is within three robust standard deviations of the median: what grew, was built or is real debris falls out.
std::vector<GroundCell> trimmed(const std::vector<GroundCell>& cells) {
    std::vector<double> values;
    for (const GroundCell& cell : cells) {
        values.push_back(cell.residual);
    }
    const double middle = median(values);
    for (double& value : values) {
        value = std::abs(value - middle);
    }
    const double reach = std::max(3.0 * 1.4826 * median(values), 1e-6);
    std::vector<GroundCell> kept;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(kept),
                 [&](const GroundCell& cell) { return std::abs(cell.residual - middle) <= reach; });
    return kept;
}

double rms(const std::vector<GroundCell>& cells) {
    double sum = 0.0;
    for (const GroundCell& cell : cells) {
        sum += cell.residual * cell.residual;
    }
    return std::sqrt(sum / static_cast<double>(cells.size()));
}

/// One step of Gauss and Newton. @param plan  also in plan
Vec3 step(const std::vector<GroundCell>& cells, bool plan) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const GroundCell& cell : cells) {
        normal += cell.row * cell.row.transpose();
        right -= cell.row * cell.residual;
    }
    if (!plan) {
        return {0.0, 0.0, right.z() / normal(2, 2)};
    }
    return normal.ldlt().solve(right);
}

/// Whether the slopes of the ground differ enough, by direction, that a shift in plan shows: 2 % at least.
bool planShows(const std::vector<GroundCell>& cells) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    for (const GroundCell& cell : cells) {
        mean += cell.row.head<2>();
        square += cell.row.head<2>() * cell.row.head<2>().transpose();
    }
    mean /= static_cast<double>(cells.size());
    square = square / static_cast<double>(cells.size()) - mean * mean.transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(square).eigenvalues()(0) > 0.02 * 0.02;
}

SurveyShift toGround(const Fitted& fitted, const Execution& execution) {
    constexpr std::size_t groundCellsLeast = 20;
    constexpr int steps = 30;
    // Ground beyond the area of interest is ground all the same.
    const std::vector<std::uint8_t> usable = comparedOn(fitted.debris, {{}, fitted.settings.scope.leftOut}, execution);
    SurveyShift shift;
    for (int i = 0; i < steps; ++i) {
        execution.check();
        const std::vector<GroundCell> all = groundCells(fitted, usable, shift.by);
        if (all.size() < groundCellsLeast) {
            throw UsageError(
                {"survey.no_ground", "The survey shows only {0} cells of ground beside the debris", {all.size()}},
                {"survey.no_ground.remedy", "Take a survey with ground around the debris, or compare without registration.", {}});
        }
        const std::vector<GroundCell> cells = trimmed(all);
        shift.planKnown = planShows(cells);
        if (i == 0) {
            shift.before = rms(cells);
        }
        shift.cells = cells.size();
        shift.after = rms(cells);
        const Vec3 by = step(cells, shift.planKnown);
        shift.by += by;
        const double far = shift.by.head<2>().norm();
        shift.atLimit = far > fitted.settings.shiftMost;
        if (shift.atLimit) {
            shift.by.head<2>() *= fitted.settings.shiftMost / far;
        }
        if (by.norm() < 1e-4) {
            break;
        }
    }
    shift.after = rms(trimmed(groundCells(fitted, usable, shift.by)));
    return shift;
}

}  // namespace

SurveyShift registered(const CellGrid& debris, const std::vector<std::uint8_t>& compared, const Survey& survey,
                       const SiteSurface& ground, const SurveySettings& settings, const Execution& execution) {
    const Fitted fitted{debris, compared, survey, ground, settings};
    switch (settings.fit) {
        case SurveyFit::None:
            return {};
        case SurveyFit::Ground:
            if (survey.isFootprint) {
                throw UsageError({"survey.footprint_ground", "An outline has no heights that could be laid on the ground", {}},
                                 {"survey.footprint_ground.remedy", "Register it to the debris, or not at all.", {}});
            }
            if (survey.heights.aboveGround) {
                throw UsageError(
                    {"survey.above_ground", "Heights above the ground have no ground that could be laid on another", {}},
                    {"survey.above_ground.remedy", "Register the survey to the debris, or not at all.", {}});
            }
            return toGround(fitted, execution);
        case SurveyFit::Debris:
            return toDebris(fitted, execution);
    }
    return {};
}

}  // namespace rubble
