#pragma once

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "widgets/figures/palette.h"

class QPainter;

namespace rubble::widgets {

/// 1, 2, 5 or 1, 3 times the powers of ten between two figures above 0, as many as there is room for.
std::vector<double> logTicks(double low, double high, double room);
/// The next number of the form 1, 2, 3 or 5 times a power of ten, down or up. @param value  above 0
double roundOut(double value, bool up);

/// One axis of a chart.
struct ChartAxis {
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
    std::vector<double> ticks;

    /// A logarithmic axis with its ticks. @param room  for how many ticks there is room
    static ChartAxis logarithmicBetween(double low, double high, double room);
    /// Where a value lies: 0 at the low end, 1 at the high one.
    double share(double value) const;
};

/// What stands at an axis.
struct AxisWords {
    QString title;
    std::function<QString(double tick)> figure;
};

/// The field of a chart with its two axes: places in it, grid lines, figures and titles.
struct ChartField {
    QRectF area;   ///< px, with figures and titles
    QRectF frame;  ///< px, of the field alone
    ChartAxis across;
    ChartAxis up;

    QPointF place(double x, double y) const;
    void paintAxes(QPainter& painter, const QFont& font, const figures::Palette& palette, const AxisWords& acrossWords,
                   const AxisWords& upWords) const;
};

/// The nearest of some places, no farther than `reach`; nothing if none is.
std::optional<std::size_t> nearestPlace(std::span<const QPointF> places, const QPointF& at, double reach);

}  // namespace rubble::widgets
