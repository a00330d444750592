#include "widgets/figures/sheets/map_head.h"

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

#include "widgets/figures/sheets/sheet_text.h"

namespace rubble::figures {

namespace {

constexpr double linePitch = 1.2;   // lines
constexpr double aboveLines = 1.2;  // lines: the subject, and what is free around both
constexpr double smallest = 0.8;    // of the letters, before a line is broken
constexpr int broken = static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignTop) | static_cast<int>(Qt::TextWordWrap);

/// A line, and how it has room in a width.
struct FittedLine {
    double text = 0.0;    ///< px, height of its letters
    double height = 0.0;  ///< px
};

FittedLine fitted(const QString& words, double width, double text) {
    const double share = width / std::max(1.0, QFontMetricsF(sheetFont(text)).horizontalAdvance(words));
    const double size = text * std::clamp(0.98 * share, smallest, 1.0);
    const QFontMetricsF metrics(sheetFont(size));
    const double all = metrics.boundingRect(QRectF(0.0, 0.0, width, 1e6), broken, words).height();
    return {size, std::max(all, QFontMetricsF(sheetFont(text)).height())};
}

}  // namespace

double MapHead::height(double width, double text) const {
    if (subject.isEmpty()) {
        return 0.0;
    }
    const double line = QFontMetricsF(sheetFont(text)).height();
    return (linePitch - 1.0) * line + fitted(subject, width, text).height + fitted(sums, width, text).height + 0.2 * line;
}

void MapHead::paint(QPainter& painter, const QRectF& box, double text, const QColor& colour) const {
    if (subject.isEmpty()) {
        return;
    }
    const double line = QFontMetricsF(sheetFont(text)).height();
    QRectF room = box;
    for (const QString& words : {subject, sums}) {
        const FittedLine fit = fitted(words, box.width(), text);
        painter.setFont(sheetFont(fit.text));
        painter.setPen(colour);
        painter.drawText(QRectF(room.topLeft(), QSizeF(box.width(), fit.height + 1.0)), broken, words);
        room.setTop(room.top() + fit.height + (linePitch - 1.0) * line);
    }
}

}  // namespace rubble::figures
