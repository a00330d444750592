#include "widgets/evidence/point_marks.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr double loupeGap = 24.0;  // px, from the place to the rim of its loupe

/// A picture has no theme: deep colours with a white rim show on all of it.
const figures::Palette& markColours() {
    return figures::palette(render::Theme::Light);
}

}  // namespace

void paintChip(QPainter& painter, const QString& text, const QPointF& corner, Qt::Alignment side) {
    const figures::Palette& colours = tints();
    const QFontMetricsF metrics(painter.font());
    QRectF chip(corner, QSizeF(metrics.horizontalAdvance(text) + 16.0, metrics.height() + 6.0));
    if (side == Qt::AlignRight) {
        chip.moveRight(corner.x());
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.chip);
    painter.drawRoundedRect(chip, 3.0, 3.0);
    painter.setPen(colours.chipText);
    painter.drawText(chip, Qt::AlignCenter, text);
    painter.setBrush(Qt::NoBrush);
}

void paintCross(QPainter& painter, const QPointF& at, const QColor& colour, const QColor& rim, double arm, double wide) {
    const auto lines = [&](const QColor& pen, double longer, double wider) {
        painter.setPen(QPen(pen, wide + wider));
        painter.drawLine(at - QPointF(arm + longer, 0.0), at + QPointF(arm + longer, 0.0));
        painter.drawLine(at - QPointF(0.0, arm + longer), at + QPointF(0.0, arm + longer));
    };
    lines(rim, 1.0, 2.0);
    lines(colour, 0.0, 0.0);
}

void paintPointMark(QPainter& painter, const QPointF& at, std::size_t number, bool used, bool chosen) {
    const QColor colour = used ? markColours().accent : markColours().finding;
    painter.setBrush(Qt::NoBrush);
    paintCross(painter, at, colour, QColor(255, 255, 255, 220), chosen ? 10.0 : 7.0, chosen ? 2.5 : 1.5);
    if (!used) {
        painter.drawEllipse(at, 10.0, 10.0);
    }
    paintChip(painter, QString::number(number) + (used ? QString() : QStringLiteral(" !")), at + QPointF(7.0, 5.0), Qt::AlignLeft);
}

void paintPendingPoint(QPainter& painter, const QPointF& at) {
    painter.setBrush(Qt::NoBrush);
    paintCross(painter, at, markColours().accent, Qt::white, 12.0, 2.0);
    painter.drawEllipse(at, 12.0, 12.0);
}

QPointF loupeMiddle(const QRectF& widget, const QPointF& at) {
    // Above and to the right of the place, else on the side where there is room.
    const double off = loupeRadius + loupeGap;
    const double x = at.x() + off + loupeRadius <= widget.right() ? at.x() + off : at.x() - off;
    const double y = at.y() - off - loupeRadius >= widget.top() ? at.y() - off : at.y() + off;
    const auto within = [](double value, double low, double high) { return std::clamp(value, low, std::max(low, high)); };
    return {within(x, widget.left() + loupeRadius, widget.right() - loupeRadius),
            within(y, widget.top() + loupeRadius, widget.bottom() - loupeRadius)};
}

void paintLoupe(QPainter& painter, const QRectF& widget, const QPointF& at, const std::function<void(QPainter&)>& content) {
    const QPointF middle = loupeMiddle(widget, at);
    QPainterPath glass;
    glass.addEllipse(middle, loupeRadius, loupeRadius);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipPath(glass);
    painter.fillPath(glass, tints().window);
    painter.save();
    painter.translate(middle);
    painter.scale(loupeScale, loupeScale);
    painter.translate(-at);
    content(painter);
    painter.restore();
    paintCross(painter, middle, Qt::black, Qt::white, 12.0, 1.0);
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 4.0));
    painter.drawEllipse(middle, loupeRadius, loupeRadius);
    painter.setPen(QPen(tints().accent, 2.0));
    painter.drawEllipse(middle, loupeRadius, loupeRadius);
    painter.restore();
}

}  // namespace rubble::widgets
