#include "widgets/basics/file_chart.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPainter>
#include <QSvgGenerator>
#include <algorithm>

#include "widgets/basics/theme.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

/// Size of text in a file whose picture is this wide, px: 9 pt where the picture is 6.3 inches wide.
constexpr double fileTextShare = 9.0 / 72.0 / 6.3;

struct Words {
    QString text;
    QFont font;
    QColor colour;
};

/// Writes words in as many lines as they take, at the top or the bottom of an area. @return where they end, towards its middle
double paintWords(QPainter& painter, const QRectF& area, double margin, const Words& words, bool top) {
    const QRectF room = area.adjusted(margin, 0.5 * margin, -margin, -0.5 * margin);
    const int flags = Qt::AlignLeft | Qt::TextWordWrap;
    const double height = QFontMetricsF(words.font).boundingRect(room, flags, words.text).height();
    const double from = top ? room.top() : room.bottom() - height;
    painter.setFont(words.font);
    painter.setPen(words.colour);
    painter.drawText(QRectF(room.left(), from, room.width(), height), flags, words.text);
    return top ? from + height + 0.5 * margin : from - 0.5 * margin;
}

}  // namespace

void FileChart::paintPage(QPainter& painter, const QSize& pixels, const ChartNote& note) const {
    const figures::FileUnits inSi;
    // Drawn at the size of a window and scaled, so that points and lines grow with the text.
    const double width = 720.0;
    const double scale = pixels.width() / width;
    painter.fillRect(QRect(QPoint(0, 0), pixels), Qt::white);
    painter.scale(scale, scale);
    QFont font = headingFont();
    font.setPixelSize(static_cast<int>(width * fileTextShare));
    const figures::Palette& tints = figures::palette(render::Theme::Print);
    QRectF area(0, 0, width, pixels.height() / scale);
    const double margin = font.pixelSize();
    QFont bold = font;
    bold.setBold(true);
    const QString title = note.subject.isEmpty() ? fileTitle() : fileTitle() + QStringLiteral(" – ") + note.subject;
    area.setTop(paintWords(painter, area, margin, {title, bold, tints.text}, true));
    QFont small = font;
    small.setPixelSize(std::max(1, static_cast<int>(0.8 * font.pixelSize())));
    if (!note.foot.isEmpty()) {
        area.setBottom(paintWords(painter, area, margin, {note.foot, small, tints.muted}, false));
    }
    if (!note.cautions.isEmpty()) {
        area.setBottom(paintWords(painter, area, margin, {note.cautions, small, tints.finding}, false));
    }
    paintFile(painter, area, font);
}

QImage FileChart::image(const QSize& pixels, const ChartNote& note) const {
    QImage picture(pixels, QImage::Format_RGB32);
    QPainter painter(&picture);
    paintPage(painter, pixels, note);
    return picture;
}

QByteArray FileChart::svg(const QSize& size, const ChartNote& note) const {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    // Qt 6.4 writes a title as it is given.
    generator.setTitle(fileTitle().toHtmlEscaped());
    QPainter painter(&generator);
    paintPage(painter, size, note);
    painter.end();
    return buffer.data();
}

}  // namespace rubble::widgets
