#include "widgets/figures/sheets/sheet_text.h"

#include <algorithm>
#include <cmath>

namespace rubble::figures {
namespace {

constexpr int smallestFont = 5;  // pixels
constexpr double inch = 0.0254;  // m

}  // namespace

QFont sheetFont(double pixels, bool italic) {
    QFont font;
    font.setPixelSize(std::max(smallestFont, static_cast<int>(std::lround(pixels))));
    font.setItalic(italic);
    return font;
}

void writeLine(QPainter& painter, const QRectF& box, const QString& text, int alignment, const QFont& font, const QColor& colour) {
    painter.setFont(font);
    painter.setPen(colour);
    painter.drawText(box, alignment | static_cast<int>(Qt::TextSingleLine), text);
}

void writeWhole(QPainter& painter, const QRectF& box, const QString& text, int alignment, const WholeText& letters) {
    const int flags = alignment | static_cast<int>(Qt::TextWordWrap);
    for (double size = letters.largest; size > letters.smallest; size *= 0.92) {
        const QFont font = sheetFont(size, letters.italic);
        painter.setFont(font);
        const QRectF needed = QFontMetricsF(font).boundingRect(box, flags, text);
        if (needed.height() <= box.height() && needed.width() <= box.width()) {
            break;
        }
    }
    painter.drawText(box, flags, text);
}

void setResolution(QImage& image, double dpi) {
    const int dotsPerMetre = static_cast<int>(std::lround(dpi / inch));
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
}

}  // namespace rubble::figures
