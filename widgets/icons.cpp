#include "widgets/icons.h"

#include <QIconEngine>
#include <QPainterPath>

#include "widgets/theme.h"

namespace rubble::widgets {

namespace {

/// Draws at any size and in the colours of the theme of the moment.
class GlyphEngine : public QIconEngine {
public:
    explicit GlyphEngine(Glyph glyph) : m_glyph(glyph) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        QColor colour = mode == QIcon::Disabled ? tints().muted : tints().text;
        if (mode != QIcon::Disabled && state == QIcon::On) {
            colour = tints().accent;
        }
        colour.setAlphaF(mode == QIcon::Disabled ? 0.5F : 1.0F);
        painter->setPen(colour);
        const int side = std::min(rect.width(), rect.height());
        drawGlyph(*painter, m_glyph, QRectF(rect.center() - QPointF(side / 2.0, side / 2.0), QSizeF(side, side)));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return image;
    }
    QIconEngine* clone() const override { return new GlyphEngine(m_glyph); }

private:
    Glyph m_glyph;
};

QPolygonF polygon(std::initializer_list<QPointF> points) {
    return QPolygonF(QList<QPointF>(points));
}

void fill(QPainter& painter, const QPolygonF& shape) {
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(shape);
    painter.setBrush(Qt::NoBrush);
}

/// Transport signs; true if the glyph is one.
bool drawTransport(QPainter& p, Glyph glyph) {
    switch (glyph) {
        case Glyph::Play:
            fill(p, polygon({{7, 4}, {20, 12}, {7, 20}}));
            return true;
        case Glyph::Pause:
            fill(p, polygon({{7, 5}, {10, 5}, {10, 19}, {7, 19}}));
            fill(p, polygon({{14, 5}, {17, 5}, {17, 19}, {14, 19}}));
            return true;
        case Glyph::First:
            p.drawLine(QPointF(6, 6), QPointF(6, 18));
            fill(p, polygon({{18, 6}, {9, 12}, {18, 18}}));
            return true;
        case Glyph::Last:
            p.drawLine(QPointF(18, 6), QPointF(18, 18));
            fill(p, polygon({{6, 6}, {15, 12}, {6, 18}}));
            return true;
        case Glyph::Back:
            fill(p, polygon({{16, 6}, {7, 12}, {16, 18}}));
            return true;
        case Glyph::Forward:
            fill(p, polygon({{8, 6}, {17, 12}, {8, 18}}));
            return true;
        case Glyph::Stop:
            fill(p, polygon({{6, 6}, {18, 6}, {18, 18}, {6, 18}}));
            return true;
        case Glyph::PlayBack:
            fill(p, polygon({{18, 4}, {5, 12}, {18, 20}}));
            return true;
        case Glyph::Loop:
            p.drawRoundedRect(QRectF(3, 7, 18, 10), 5, 5);
            fill(p, polygon({{10, 3.5}, {15, 7}, {10, 10.5}}));
            return true;
        case Glyph::Bookmark:
            p.drawPolygon(polygon({{7, 3}, {17, 3}, {17, 21}, {12, 16}, {7, 21}}));
            return true;
        default:
            return false;
    }
}

/// Signs of the views; true if the glyph is one.
bool drawViewSign(QPainter& p, Glyph glyph) {
    const QRectF frame(3, 5, 18, 14);
    QColor shade = p.pen().color();
    shade.setAlphaF(0.35F);
    switch (glyph) {
        case Glyph::Beside:
            p.drawRect(frame);
            p.drawLine(QPointF(12, 5), QPointF(12, 19));
            return true;
        case Glyph::Close:
            p.drawLine(QPointF(6, 6), QPointF(18, 18));
            p.drawLine(QPointF(18, 6), QPointF(6, 18));
            return true;
        case Glyph::Float:
            p.drawRect(QRectF(5, 10, 9, 9));
            p.drawPolyline(QPolygonF({{10, 10}, {10, 5}, {19, 5}, {19, 14}, {14, 14}}));
            return true;
        case Glyph::Stacked:
            p.drawRect(frame);
            p.drawLine(QPointF(3, 12), QPointF(21, 12));
            return true;
        case Glyph::FeOnly:
            p.drawRect(frame);
            p.fillRect(QRectF(6, 9, 12, 6), shade);
            return true;
        case Glyph::FragmentsOnly:
            p.drawRect(frame);
            p.fillRect(QRectF(6, 14, 3, 3), p.pen().color());
            p.fillRect(QRectF(10.5, 12, 4, 5), p.pen().color());
            p.fillRect(QRectF(16, 15, 2, 2), p.pen().color());
            return true;
        case Glyph::Link:
            p.drawRoundedRect(QRectF(3, 8.5, 10, 7), 3.5, 3.5);
            p.drawRoundedRect(QRectF(11, 8.5, 10, 7), 3.5, 3.5);
            return true;
        case Glyph::Fit:
            p.drawPolyline(polygon({{4, 9}, {4, 4}, {9, 4}}));
            p.drawPolyline(polygon({{15, 4}, {20, 4}, {20, 9}}));
            p.drawPolyline(polygon({{20, 15}, {20, 20}, {15, 20}}));
            p.drawPolyline(polygon({{9, 20}, {4, 20}, {4, 15}}));
            p.drawRect(QRectF(9, 9, 6, 6));
            return true;
        default:
            return false;
    }
}

void drawArrowBack(QPainter& p) {
    p.drawPolyline(polygon({{9, 5}, {4, 10}, {9, 15}}));
    QPainterPath path(QPointF(4, 10));
    path.lineTo(14, 10);
    path.arcTo(QRectF(9, 10, 10, 10), 90, -180);
    path.lineTo(9, 20);
    p.drawPath(path);
}

void drawWave(QPainter& p, double y) {
    QPainterPath path(QPointF(3, y));
    for (double x = 3.0; x < 20.0; x += 9.0) {
        path.cubicTo(x + 3.0, y - 4.0, x + 6.0, y + 4.0, x + 9.0, y);
    }
    p.drawPath(path);
}

/// Signs inside panels; true if the glyph is one.
bool drawPanelSign(QPainter& p, Glyph glyph) {
    switch (glyph) {
        case Glyph::Unfold:
            p.drawPolyline(polygon({{9, 6}, {15, 12}, {9, 18}}));
            return true;
        case Glyph::Fold:
            p.drawPolyline(polygon({{6, 9}, {12, 15}, {18, 9}}));
            return true;
        case Glyph::Reset:
            p.drawArc(QRectF(5, 5, 14, 14), 150 * 16, -280 * 16);
            p.drawPolyline(polygon({{4, 3}, {6, 9}, {12, 8}}));
            return true;
        default:
            return false;
    }
}

void drawDocumentSign(QPainter& p, Glyph glyph) {
    switch (glyph) {
        case Glyph::Case:
            p.drawPolygon(polygon({{5, 3}, {14, 3}, {19, 8}, {19, 21}, {5, 21}}));
            p.drawPolyline(polygon({{14, 3}, {14, 8}, {19, 8}}));
            p.drawLine(QPointF(8, 13), QPointF(16, 13));
            p.drawLine(QPointF(8, 17), QPointF(14, 17));
            break;
        case Glyph::Fragments:
            p.drawPolygon(polygon({{4, 13}, {9, 9}, {13, 14}, {9, 20}, {4, 18}}));
            p.drawPolygon(polygon({{14, 4}, {20, 6}, {19, 11}, {14, 10}}));
            p.drawPolygon(polygon({{16, 15}, {21, 16}, {19, 20}, {15, 19}}));
            break;
        case Glyph::Grid:
            p.drawRect(QRectF(4, 4, 16, 16));
            p.drawLine(QPointF(4, 12), QPointF(20, 12));
            p.drawLine(QPointF(12, 4), QPointF(12, 20));
            break;
        case Glyph::Effects:
            // A drop over waves, and wind.
            p.drawPolyline(polygon({{3, 6}, {13, 6}, {15, 4}}));
            p.drawPolyline(polygon({{3, 10}, {17, 10}, {20, 7}}));
            drawWave(p, 15);
            drawWave(p, 19.5);
            break;
        case Glyph::Run:
            p.drawLine(QPointF(3, 20), QPointF(21, 20));
            p.drawRect(QRectF(5, 14, 6, 6));
            p.drawPolygon(polygon({{13, 8}, {18, 6}, {20, 11}, {15, 13}}));
            p.drawLine(QPointF(8, 4), QPointF(8, 10));
            p.drawPolyline(polygon({{5.5, 7.5}, {8, 10}, {10.5, 7.5}}));
            break;
        case Glyph::Accuracy:
            // Points that rise along two axes.
            p.drawPolyline(polygon({{4, 3}, {4, 20}, {21, 20}}));
            p.drawEllipse(QPointF(8.5, 15.5), 1.4, 1.4);
            p.drawEllipse(QPointF(12, 9.5), 1.4, 1.4);
            p.drawEllipse(QPointF(18, 6.5), 1.4, 1.4);
            break;
        case Glyph::Evidence:
            // A camera.
            p.drawPolygon(polygon({{3, 8}, {7.5, 8}, {9, 5}, {15, 5}, {16.5, 8}, {21, 8}, {21, 19}, {3, 19}}));
            p.drawEllipse(QPointF(12, 13), 3.6, 3.6);
            break;
        case Glyph::Report:
            // A page with lines.
            p.drawPolygon(polygon({{5, 3}, {15, 3}, {19, 7}, {19, 21}, {5, 21}}));
            p.drawLine(QPointF(8, 10), QPointF(16, 10));
            p.drawLine(QPointF(8, 13.5), QPointF(16, 13.5));
            p.drawLine(QPointF(8, 17), QPointF(13, 17));
            break;
        case Glyph::Open:
            p.drawPolygon(polygon({{3, 19}, {3, 5}, {9, 5}, {11, 8}, {20, 8}, {20, 19}}));
            p.drawLine(QPointF(3, 12), QPointF(20, 12));
            break;
        case Glyph::Save:
            p.drawRect(QRectF(4, 4, 16, 16));
            p.drawRect(QRectF(8, 13, 8, 7));
            p.drawRect(QRectF(8, 4, 7, 5));
            break;
        case Glyph::Undo:
            drawArrowBack(p);
            break;
        case Glyph::Redo:
            p.save();
            p.translate(24, 0);
            p.scale(-1, 1);
            drawArrowBack(p);
            p.restore();
            break;
        case Glyph::Live:
            p.drawEllipse(QRectF(8, 8, 8, 8));
            p.drawArc(QRectF(3, 3, 18, 18), 130 * 16, 100 * 16);
            p.drawArc(QRectF(3, 3, 18, 18), -50 * 16, 100 * 16);
            break;
        default:
            p.drawEllipse(QRectF(3, 3, 18, 18));
            p.drawArc(QRectF(9, 7, 6, 6), -60 * 16, 220 * 16);
            p.drawLine(QPointF(12, 13), QPointF(12, 15));
            p.drawPoint(QPointF(12, 18));
            break;
    }
}

}  // namespace

void drawGlyph(QPainter& painter, Glyph glyph, const QRectF& square) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(square.topLeft());
    painter.scale(square.width() / 24.0, square.height() / 24.0);
    painter.setPen(QPen(painter.pen().color(), 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    if (!drawTransport(painter, glyph) && !drawViewSign(painter, glyph) && !drawPanelSign(painter, glyph)) {
        drawDocumentSign(painter, glyph);
    }
    painter.restore();
}

void drawWarning(QPainter& painter, const QPointF& centre, const QColor& colour, const QColor& mark) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(centre);
    painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(colour);
    painter.drawPolygon(polygon({{0.0, -6.5}, {6.8, 5.5}, {-6.8, 5.5}}));
    painter.setPen(QPen(mark, 1.7, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0.0, -2.8), QPointF(0.0, 1.2));
    painter.drawPoint(QPointF(0.0, 3.9));
    painter.restore();
}

QIcon glyphIcon(Glyph glyph) {
    return QIcon(new GlyphEngine(glyph));
}

}  // namespace rubble::widgets
