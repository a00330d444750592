#pragma once

#include <QString>
#include <vector>

#include "core/analysis/accuracy/accuracy_front.h"

namespace rubble::widgets {

/// A setting of a sweep for people: "multiple 2, cluster shape hull", "as published", "reference".
QString settingWords(const std::string& setting);
/// "bodies", "ms per step", "wall time", "live FPS"
QString costWords(CostKind kind);
/// With its unit, for an axis: "cost: milliseconds per step, mean"
QString costAxisWords(CostKind kind);
/// "footprint overlap", "within 0.1 m"
QString accuracyWords(const AccuracyKind& kind);
/// With its unit and what it compares with, for an axis.
QString accuracyAxisWords(const AccuracyKind& kind);
/// What the kind is, in a sentence.
QString accuracyTip(const AccuracyKind& kind);
/// A figure with its unit, as in the table: "0.93", "0.4 m", "62 %"; an en dash for NaN.
QString shownCost(CostKind kind, double value);
QString shownAccuracy(const AccuracyKind& kind, double value);

/// The numbers of one setting, one to a line: what the chart says on hover and reads aloud.
QString pointWords(const AccuracyPoint& point);

}  // namespace rubble::widgets
