#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/analysis/accuracy/accuracy_study.h"

namespace rubble {

/// What a setting costs, in one figure.
enum class CostKind : std::uint8_t {
    Bodies,    ///< clusters: known of every setting, wherever it was simulated
    StepMean,  ///< ms per step
    Wall,      ///< s, wall time of the run
    Fps,       ///< live frames per second: the more the better
};
inline constexpr std::size_t costKindCount = 4;

/// How accurate a setting is, in one figure: a measure of debris as an amount, or the share of fragments within a tolerance.
struct AccuracyKind {
    Measure measure = Measure::MassMap;
    std::optional<double> tolerance;  ///< m; set: the accuracy rate within it, whatever the measure

    bool operator==(const AccuracyKind&) const = default;
    /// Overlaps and rates: 1 is the reference itself. Otherwise 0 is.
    bool moreIsBetter() const;
};

/// All kinds of accuracy of a sweep with these tolerances [m], the robust ones first.
std::vector<AccuracyKind> accuracyKinds(const std::vector<double>& tolerances);

/// NaN where it is not known.
double costOf(const AccuracyPoint& point, CostKind kind);
/// NaN where the debris has no such figure, or the tolerance was not measured.
double accuracyOf(const DebrisDifference& difference, const AccuracyKind& kind);

/// Smallest and largest of that among a setting and its own repeats; unset without a repeat, or where none has such a figure.
std::optional<std::pair<double, double>> accuracyRange(const AccuracyPoint& point, const AccuracyKind& kind);

/// The values between which a difference from the reference means nothing, since the reference repeats no better; unset without a
/// repeat or where the floor has no such figure.
std::optional<std::pair<double, double>> floorBand(const AccuracyReport& report, const AccuracyKind& kind);

/// A setting as a point of the chart.
struct CostAccuracy {
    double cost = 0.0;
    double accuracy = 0.0;
};
/// The points that no other beats on one side without losing on the other, by rising cost figure. Points that are no numbers are on
/// no front; of equal points the first is.
std::vector<std::size_t> paretoFront(std::span<const CostAccuracy> points, bool moreCostIsBetter, bool moreAccuracyIsBetter);

/// Where a rate lies on an axis of cost: between the two settings, next to each other in cost, whose live FPS enclose it,
/// interpolated in logarithms. Unset if no two do.
/// @param target  frames per second
std::optional<double> costAtRate(const AccuracyReport& report, CostKind kind, double target);

}  // namespace rubble
