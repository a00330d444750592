#include "widgets/accuracy/accuracy_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "widgets/basics/translated.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

struct MeasureWords {
    const char* name;
    const char* axis;
    const char* tip;
    const char* unit;
};

/// In the order of Measure.
constexpr std::array<MeasureWords, measureCount> measureWords{{
    {QT_TRANSLATE_NOOP("rubble::widgets", "mass map"), QT_TRANSLATE_NOOP("rubble::widgets", "difference of the mass map"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Share of the mass that lies in other cells of 2 m than in the reference: 0 is the same"),
     ""},
    {QT_TRANSLATE_NOOP("rubble::widgets", "core overlap"),
     QT_TRANSLATE_NOOP("rubble::widgets", "core overlap with the reference (IoU)"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Cells in both cores, which hold 95 % of the mass, over cells in either: 1 is the same"),
     ""},
    {QT_TRANSLATE_NOOP("rubble::widgets", "footprint overlap"),
     QT_TRANSLATE_NOOP("rubble::widgets", "footprint overlap with the reference (IoU)"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Cells of 1 m in both footprints over cells in either: 1 is the same"), ""},
    {QT_TRANSLATE_NOOP("rubble::widgets", "run-out"), QT_TRANSLATE_NOOP("rubble::widgets", "error of the 95 % run-out, m"),
     QT_TRANSLATE_NOOP("rubble::widgets", "How far the distance within which 95 % of the mass lies differs from the reference"),
     "m"},
    {QT_TRANSLATE_NOOP("rubble::widgets", "height map"),
     QT_TRANSLATE_NOOP("rubble::widgets", "height map, root mean square error, m"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Root of the mean square difference of the heights of the pile over both footprints"),
     "m"},
    {QT_TRANSLATE_NOOP("rubble::widgets", "mean height"),
     QT_TRANSLATE_NOOP("rubble::widgets", "error of the mean height of the mass, m"),
     QT_TRANSLATE_NOOP("rubble::widgets", "How far the mean height of the mass above ground differs from the reference"), "m"},
    {QT_TRANSLATE_NOOP("rubble::widgets", "centroid"), QT_TRANSLATE_NOOP("rubble::widgets", "shift of the centroid, m"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Distance between the centroids of the mass"), "m"},
    {QT_TRANSLATE_NOOP("rubble::widgets", "fragment error"),
     QT_TRANSLATE_NOOP("rubble::widgets", "median error of the fragments, m"),
     QT_TRANSLATE_NOOP("rubble::widgets", "Median over the fragments of the distance from their place in the reference"), "m"},
}};

const MeasureWords& of(const AccuracyKind& kind) {
    return measureWords[static_cast<std::size_t>(kind.measure)];
}

QString metres(double value) {
    return QLocale().toString(value, 'g', 6);
}

}  // namespace

QString settingWords(const std::string& setting) {
    if (setting == referenceSetting) {
        return tr("reference");
    }
    if (setting == floorSetting) {
        return tr("repeat floor");
    }
    if (setting == paperSetting) {
        return tr("as published");
    }
    QStringList parts = QString::fromStdString(setting).split(u' ', Qt::SkipEmptyParts);
    for (QString& part : parts) {
        part.replace(u'=', u' ').replace(u'_', u' ');
    }
    return parts.join(QStringLiteral(", "));
}

QString costWords(CostKind kind) {
    return kind == CostKind::Bodies     ? tr("bodies")
           : kind == CostKind::StepMean ? tr("ms per step")
           : kind == CostKind::Wall     ? tr("wall time")
                                        : tr("live FPS");
}

QString costAxisWords(CostKind kind) {
    return kind == CostKind::Bodies     ? tr("cost: bodies that the engine moves")
           : kind == CostKind::StepMean ? tr("cost: milliseconds per step, mean")
           : kind == CostKind::Wall     ? tr("cost: wall time of the run, s")
                                        : tr("live frames per second, mean");
}

QString accuracyWords(const AccuracyKind& kind) {
    return kind.tolerance ? tr("within %1 m").arg(metres(*kind.tolerance)) : tr(of(kind).name);
}

QString accuracyAxisWords(const AccuracyKind& kind) {
    return kind.tolerance ? tr("fragments within %1 m of their place in the reference, %").arg(metres(*kind.tolerance))
                          : tr(of(kind).axis);
}

QString accuracyTip(const AccuracyKind& kind) {
    return kind.tolerance
               ? tr("Share of the fragments that lie within %1 m of where the reference has them").arg(metres(*kind.tolerance))
               : tr(of(kind).tip);
}

QString shownCost(CostKind kind, double value) {
    return !std::isfinite(value)      ? shownNumber(value)
           : kind == CostKind::Bodies ? tr("%1 bodies").arg(shownCount(std::llround(value)))
           : kind == CostKind::Wall   ? shownDuration(value)
           : kind == CostKind::Fps    ? shownNumber(value) + tr(" FPS")
                                      : shownNumber(value) + tr(" ms");
}

QString shownAccuracy(const AccuracyKind& kind, double value) {
    if (!std::isfinite(value)) {
        return shownNumber(value);
    }
    if (kind.tolerance) {
        return shownShare(value);
    }
    const QString unit = QString::fromLatin1(of(kind).unit);
    return unit.isEmpty() ? QLocale().toString(value, 'f', 3) : shownNumber(value) + QChar(0x00A0) + unit;
}

QString pointWords(const AccuracyPoint& point) {
    QStringList lines{settingWords(point.setting)};
    if (const double bodies = costOf(point, CostKind::Bodies); std::isfinite(bodies)) {
        lines << shownCost(CostKind::Bodies, bodies);
    }
    if (!point.failure.empty()) {
        lines << tr("not simulated: %1").arg(worded(point.failure));
        return lines.join(u'\n');
    }
    if (!point.done) {
        lines << tr("not done yet");
        return lines.join(u'\n');
    }
    for (const CostKind kind : {CostKind::StepMean, CostKind::Wall, CostKind::Fps}) {
        const double value = costOf(point, kind);
        lines << QStringLiteral("%1: %2").arg(costWords(kind), std::isfinite(value) ? shownCost(kind, value) : tr("not measured"));
    }
    for (const AccuracyKind& kind : accuracyKinds(point.difference.tolerances)) {
        QString line = QStringLiteral("%1: %2").arg(accuracyWords(kind), shownAccuracy(kind, accuracyOf(point.difference, kind)));
        if (!kind.tolerance && point.standings[static_cast<std::size_t>(kind.measure)] == Standing::Below) {
            line += tr(" (no more than the floor)");
        }
        if (const auto range = accuracyRange(point, kind)) {
            line += tr(", %1 to %2 over %3 runs")
                        .arg(shownAccuracy(kind, range->first), shownAccuracy(kind, range->second))
                        .arg(1 + point.repeats.size());
        }
        lines << line;
    }
    if (point.breaches > 0) {
        lines << tr("limits of health passed: %1").arg(shownCount(point.breaches));
    }
    if (point.cost.disturbed()) {
        lines << tr("other programs took %1 of the processors while it was timed").arg(shownShare(point.cost.othersShare, 0));
    }
    return lines.join(u'\n');
}

}  // namespace rubble::widgets
