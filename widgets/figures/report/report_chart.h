#pragma once

#include <QColor>
#include <QString>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "widgets/render/basics/view.h"

class QPainter;
class QPointF;
class QRectF;

namespace rubble::figures {

/// The mark of a point that no line joins.
enum class ChartMark : std::uint8_t { Dot, Square, Triangle, Diamond };
/// Draws a mark filled in a colour. @param radius  pixels, of a circle about it
void paintMark(QPainter& painter, ChartMark mark, const QColor& colour, const QPointF& place, double radius);

/// A row of points of a chart, joined by a line or not.
struct ChartSeries {
    struct Point {
        double x = 0.0;
        double y = 0.0;
        QString label;  ///< beside it, empty: none
    };
    QString name;  ///< written at its last point; empty: none
    QColor colour;
    bool line = true;
    bool dashed = false;
    std::vector<Point> points;
    ChartMark mark = ChartMark::Dot;  ///< where there is no line
};

/// A plain chart, for print unless a theme is given: axes with units, direct labels, a band.
struct ReportChart {
    QString xTitle, yTitle;  ///< with unit
    bool logX = false;
    bool fromZero = true;  ///< the y axis
    std::vector<ChartSeries> series;
    double band = std::numeric_limits<double>::quiet_NaN();  ///< from 0 up to here; NaN: none
    QString bandName;
    render::Theme theme = render::Theme::Print;

    void paint(QPainter& painter, const QRectF& area, double textHeight) const;
};

}  // namespace rubble::figures
