#include "widgets/figures/sheets/map_edges.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "widgets/figures/sheets/sheet_text.h"

namespace rubble::figures {

namespace {

constexpr double leastTickWords = 5.0;  // sizes of small text that a coordinate needs

}  // namespace

std::vector<EdgeTick> edgeTicks(const SiteFit& site, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double step) {
    const Vec3 first = site.toWorld(Vec3(from.x(), from.y(), 0.0));
    const Vec3 way = site.toWorld(Vec3(to.x(), to.y(), 0.0)) - first;
    const int axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    std::vector<EdgeTick> ticks;
    if (!(step > 0.0) || way[axis] == 0.0) {
        return ticks;
    }
    const double low = std::min(first[axis], first[axis] + way[axis]);
    const double high = std::max(first[axis], first[axis] + way[axis]);
    const QString letter = site.angle == 0.0 ? QStringLiteral("%1")
                           : axis == 0       ? QCoreApplication::translate("rubble::figures::MapEdges", "E %1")
                                             : QCoreApplication::translate("rubble::figures::MapEdges", "N %1");
    for (double value = step * std::ceil(low / step); value <= high; value += step) {
        const double shown = std::abs(value) < 1e-9 ? 0.0 : value;
        ticks.push_back({(value - first[axis]) / way[axis], letter.arg(QString::number(shown, 'g', 10))});
    }
    return ticks;
}

double stepAcross(double step, double metres, double small) {
    while (step > 0.0 && step / metres < leastTickWords * small) {
        step *= 2.0;
    }
    return step;
}

void drawCoordinates(QPainter& painter, const MapEdges& edges, const SiteFit& site, const QString& unit, double small,
                     const QColor& line, const QColor& text) {
    painter.setFont(sheetFont(small));
    const double tick = 0.4 * small;
    const QPen stroke(line, painter.pen().widthF());
    const auto draw = [&](const QPointF& at, const QPointF& out, const QRectF& box, int alignment, const QString& words) {
        painter.setPen(stroke);
        painter.drawLine(at, at + out);
        painter.setPen(text);
        painter.drawText(box, alignment | static_cast<int>(Qt::TextSingleLine), words);
    };
    const QRectF& frame = edges.frame;
    for (const EdgeTick& mark : edgeTicks(site, edges.low, {edges.high.x(), edges.low.y()}, edges.across)) {
        const double x = frame.left() + mark.at * frame.width();
        draw({x, frame.bottom()}, {0.0, tick}, QRectF(x - 40.0 * small, frame.bottom() + tick, 80.0 * small, 1.6 * small),
             static_cast<int>(Qt::AlignHCenter | Qt::AlignTop), mark.text);
    }
    for (const EdgeTick& mark : edgeTicks(site, edges.low, {edges.low.x(), edges.high.y()}, edges.up)) {
        const double y = frame.bottom() - mark.at * frame.height();
        draw({frame.left(), y}, {-tick, 0.0}, QRectF(0.0, y - small, frame.left() - 1.5 * tick, 2.0 * small),
             static_cast<int>(Qt::AlignRight | Qt::AlignVCenter), mark.text);
    }
    // The unit stands once, in the corner between both axes.
    painter.drawText(QRectF(0.0, frame.bottom() + tick, std::max(frame.left() - 2.6 * small, 2.0 * small), 1.6 * small),
                     static_cast<int>(Qt::AlignRight | Qt::AlignTop | Qt::TextSingleLine), u'[' + unit + u']');
}

}  // namespace rubble::figures
