#include "widgets/figures/sheets/map_contours.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/evidence/maps/height_contours.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/sheets/map_words.h"
#include "widgets/figures/sheets/sheet_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {
namespace {

struct Line {
    int number = 0;  ///< of its level, 1: the lowest
    QPolygonF corners;
    double length = 0.0;  ///< px
};

double lengthOf(const QPolygonF& ring) {
    double length = 0.0;
    for (qsizetype k = 0; k < ring.size(); ++k) {
        const QPointF step = ring[(k + 1) % ring.size()] - ring[k];
        length += std::hypot(step.x(), step.y());
    }
    return length;
}

/// Numbers of levels, none upon another.
class Numbers {
public:
    Numbers(QPainter& painter, const ContourStyle& style) : m_painter(painter), m_style(style) {}

    /// On the longest line of a level that has a place for it.
    void write(int number, std::vector<const Line*> lines) {
        std::sort(lines.begin(), lines.end(), [](const Line* a, const Line* b) { return a->length > b->length; });
        const QString text = legendNumber(number * m_style.spacing * shownUnit("m").perSi);
        const QFontMetricsF metrics(sheetFont(m_style.text));
        const QSizeF size(metrics.horizontalAdvance(text) + 0.4 * m_style.text, metrics.height());
        constexpr double shortest = 3.0;  // widths of the number, of a line that still shows beside it
        for (const Line* line : lines) {
            if (line->length < shortest * size.width()) {
                return;
            }
            for (const QPointF& corner : line->corners) {
                const QRectF box(corner - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
                if (m_style.frame.contains(box) &&
                    std::none_of(m_taken.begin(), m_taken.end(), [&](const QRectF& other) { return other.intersects(box); })) {
                    writeAt(box, text);
                    return;
                }
            }
        }
    }

private:
    void writeAt(const QRectF& box, const QString& text) {
        m_painter.fillRect(box.adjusted(0.0, 0.1 * box.height(), 0.0, -0.1 * box.height()), QColor(255, 255, 255, 215));
        writeLine(m_painter, box, text, Qt::AlignCenter, sheetFont(m_style.text), QColor(0x20, 0x22, 0x26));
        const double apart = 1.5 * m_style.text;
        m_taken.push_back(box.adjusted(-apart, -apart, apart, apart));
    }

    QPainter& m_painter;
    const ContourStyle& m_style;
    std::vector<QRectF> m_taken;
};

}  // namespace

bool hasContours(const DebrisMap& map, double spacing) {
    return spacing > 0.0 && map.has(MapLayer::Height) && !map.layer(MapLayer::Height).empty();
}

int numberedEvery(double spacing, double highest) {
    constexpr double few = 5.0;
    if (highest <= few * spacing) {
        return 1;
    }
    // Quarters and halves to whole ones, tenths to halves.
    return std::abs(4.0 * spacing - std::round(4.0 * spacing)) < 1e-9 && spacing < 1.0
               ? static_cast<int>(std::lround(1.0 / spacing))
               : 5;
}

void drawContours(QPainter& painter, const DebrisMap& map, const ContourStyle& style) {
    if (!hasContours(map, style.spacing)) {
        return;
    }
    std::vector<Line> lines;
    int most = 0;
    for (const HeightContour& contour : heightContours(map.cells, map.layer(MapLayer::Height), map.cell, style.spacing)) {
        Line& line = lines.emplace_back();
        line.number = static_cast<int>(std::lround(contour.level / style.spacing));
        most = std::max(most, line.number);
        for (const Eigen::Vector2d& corner : contour.corners) {
            line.corners << style.pixel(corner);
        }
        line.length = lengthOf(line.corners);
    }
    const int every = numberedEvery(style.spacing, most * style.spacing);
    painter.save();
    painter.setClipRect(style.frame);
    painter.setBrush(Qt::NoBrush);
    QPen thin = style.pen;
    QColor pale = thin.color();
    pale.setAlphaF(0.5F * pale.alphaF());
    thin.setColor(pale);
    thin.setWidthF(0.6 * style.pen.widthF());
    for (const Line& line : lines) {
        painter.setPen(line.number % every == 0 ? style.pen : thin);
        painter.drawPolygon(line.corners);
    }
    Numbers numbers(painter, style);
    for (int number = every; number <= most; number += every) {
        std::vector<const Line*> level;
        for (const Line& line : lines) {
            if (line.number == number) {
                level.push_back(&line);
            }
        }
        numbers.write(number, std::move(level));
    }
    painter.restore();
}

}  // namespace rubble::figures
