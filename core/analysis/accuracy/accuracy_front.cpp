#include "core/analysis/accuracy/accuracy_front.h"

#include <algorithm>
#include <cmath>

#include "core/base/unknown.h"

namespace rubble {

namespace {

bool overlap(Measure measure) {
    return measure == Measure::CoreIou || measure == Measure::FootprintIou;
}

}  // namespace

bool AccuracyKind::moreIsBetter() const {
    return tolerance.has_value() || overlap(measure);
}

std::vector<AccuracyKind> accuracyKinds(const std::vector<double>& tolerances) {
    std::vector<AccuracyKind> kinds;
    for (std::size_t m = 0; m < measureCount; ++m) {
        kinds.push_back({static_cast<Measure>(m), std::nullopt});
    }
    for (const double tolerance : tolerances) {
        kinds.push_back({Measure::MedianDistance, tolerance});
    }
    return kinds;
}

double costOf(const AccuracyPoint& point, CostKind kind) {
    switch (kind) {
        case CostKind::Bodies:
            return point.bodies > 0 ? static_cast<double>(point.bodies) : unknown;
        case CostKind::StepMean:
            return point.cost.stepMeanMs;
        case CostKind::Wall:
            return point.cost.wallSeconds;
        case CostKind::Fps:
            return point.cost.fps;
    }
    return unknown;
}

double accuracyOf(const DebrisDifference& difference, const AccuracyKind& kind) {
    if (!kind.tolerance) {
        const double value = difference.of(kind.measure);
        return overlap(kind.measure) ? value : std::abs(value);
    }
    const auto found = std::find(difference.tolerances.begin(), difference.tolerances.end(), *kind.tolerance);
    const auto index = static_cast<std::size_t>(found - difference.tolerances.begin());
    return index < difference.accuracy.size() ? difference.accuracy[index] : unknown;
}

std::optional<std::pair<double, double>> accuracyRange(const AccuracyPoint& point, const AccuracyKind& kind) {
    if (!point.done || point.repeats.empty()) {
        return std::nullopt;
    }
    const double own = accuracyOf(point.difference, kind);
    std::pair range(own, own);
    for (const DebrisDifference& repeat : point.repeats) {
        const double value = accuracyOf(repeat, kind);
        range = {std::fmin(range.first, value), std::fmax(range.second, value)};
    }
    return std::isfinite(range.first) ? std::optional(range) : std::nullopt;
}

std::optional<std::pair<double, double>> floorBand(const AccuracyReport& report, const AccuracyKind& kind) {
    if (!report.floor || report.floor->repeats.empty()) {
        return std::nullopt;
    }
    const double edge = accuracyOf(report.floor->largest, kind);
    if (!std::isfinite(edge)) {
        return std::nullopt;
    }
    return kind.moreIsBetter() ? std::pair(edge, 1.0) : std::pair(0.0, edge);
}

std::vector<std::size_t> paretoFront(std::span<const CostAccuracy> points, bool moreCostIsBetter, bool moreAccuracyIsBetter) {
    const auto cost = [&](std::size_t i) { return moreCostIsBetter ? -points[i].cost : points[i].cost; };
    const auto loss = [&](std::size_t i) { return moreAccuracyIsBetter ? -points[i].accuracy : points[i].accuracy; };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].accuracy)) {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return cost(a) < cost(b) || (cost(a) == cost(b) && loss(a) < loss(b)); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || loss(i) < loss(front.back())) {
            front.push_back(i);
        }
    }
    if (moreCostIsBetter) {
        std::reverse(front.begin(), front.end());
    }
    return front;
}

std::optional<double> costAtRate(const AccuracyReport& report, CostKind kind, double target) {
    if (kind == CostKind::Fps) {
        return target;
    }
    std::vector<std::pair<double, double>> known;  // cost, FPS
    const auto add = [&](const AccuracyPoint& point) {
        const double cost = costOf(point, kind);
        if (std::isfinite(cost) && cost > 0.0 && std::isfinite(point.cost.fps) && point.cost.fps > 0.0) {
            known.emplace_back(cost, point.cost.fps);
        }
    };
    add(report.reference);
    std::for_each(report.points.begin(), report.points.end(), add);
    std::sort(known.begin(), known.end());
    for (std::size_t i = 1; i < known.size(); ++i) {
        const auto [lowCost, highRate] = known[i - 1];
        const auto [highCost, lowRate] = known[i];
        if (highRate >= target && lowRate <= target) {
            const double share = highRate > lowRate ? std::log(highRate / target) / std::log(highRate / lowRate) : 0.5;
            return lowCost * std::pow(highCost / lowCost, share);
        }
    }
    return std::nullopt;
}

}  // namespace rubble
