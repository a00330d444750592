#include "core/evidence/surveys/survey_noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr std::size_t cellsLeast = 100;  // that an estimate takes
constexpr double normalShare = 1.4826;   // of the standard deviation over the median of absolute values

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Correlation of cells that lie some steps apart along rows and columns; NaN without such pairs.
double correlationAt(const CellGrid& noise, int steps) {
    double products = 0.0;
    double squares = 0.0;
    const auto add = [&](double a, double b) {
        if (std::isfinite(a) && std::isfinite(b)) {
            products += a * b;
            squares += 0.5 * (a * a + b * b);
        }
    };
    for (int row = 0; row < noise.rows; ++row) {
        for (int column = 0; column < noise.columns; ++column) {
            const double here = noise.values[noise.index(column, row)];
            if (column + steps < noise.columns) {
                add(here, noise.values[noise.index(column + steps, row)]);
            }
            if (row + steps < noise.rows) {
                add(here, noise.values[noise.index(column, row + steps)]);
            }
        }
    }
    return squares > 0.0 ? products / squares : unknown;
}

/// m, where the correlation falls below 1/e, between the steps on either side of it.
double correlationLength(const CellGrid& noise) {
    constexpr double fallen = 0.36787944117144233;
    const int most = std::min(200, std::max(noise.columns, noise.rows) / 2);
    double before = 1.0;
    for (int steps = 1; steps <= most; ++steps) {
        const double here = correlationAt(noise, steps);
        if (std::isnan(here)) {
            return unknown;
        }
        if (here < fallen) {
            return noise.cell * (steps - 1 + (before - fallen) / (before - here));
        }
        before = here;
    }
    return noise.cell * most;
}

/// Takes the median, the deviation and the correlation of the cells that lie far from all debris.
void estimate(SurveyNoise& found, const CellGrid& surveyed, const std::vector<double>& distances) {
    CellGrid noise = surveyed;
    std::vector<double> values;
    for (std::size_t k = 0; k < noise.values.size(); ++k) {
        if (std::isfinite(noise.values[k]) && distances[k] * surveyed.cell >= farFromDebris) {
            values.push_back(noise.values[k]);
        } else {
            noise.values[k] = unknown;
        }
    }
    found.cells = values.size();
    if (values.size() < cellsLeast) {
        return;
    }
    found.offset = medianOf(values);
    for (double& value : values) {
        value = std::abs(value - found.offset);
    }
    found.deviation = normalShare * medianOf(values);
    found.source = SurveyNoise::Source::Estimated;
    // What stands there, as trees and vehicles, is no noise.
    for (double& value : noise.values) {
        value -= found.offset;
        if (std::abs(value) > 3.0 * found.deviation) {
            value = unknown;
        }
    }
    // Rounding of heights is no noise either.
    if (found.deviation > 1e-6) {
        found.correlation = correlationLength(noise);
    }
}

}  // namespace

SurveyNoise noiseOf(const CellGrid& surveyed, const std::vector<double>& distances, std::optional<double> ofSurvey,
                    std::optional<double> ofGround) {
    SurveyNoise found;
    found.offset = found.correlation = unknown;
    estimate(found, surveyed, distances);
    if (ofSurvey || ofGround) {
        const double stated = std::hypot(ofSurvey.value_or(0.0), ofGround.value_or(0.0));
        if ((ofSurvey && ofGround) || stated >= found.deviation) {
            found.deviation = stated;
            found.source = SurveyNoise::Source::Stated;
        }
    }
    return found;
}

}  // namespace rubble
