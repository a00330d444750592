#include "widgets/basics/file_chart.h"

#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

#include "widgets/basics/theme.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

/// Size of text in a file whose picture is this wide, px: 9 pt where the picture is 6.3 inches wide.
constexpr double fileTextShare = 9.0 / 72.0 / 6.3;

}  // namespace

void FileChart::paintPage(QPainter& painter, const QSize& pixels) const {
    const figures::FileUnits inSi;
    // Drawn at the size of a window and scaled, so that points and lines grow with the text.
    const double width = 720.0;
    const double scale = pixels.width() / width;
    painter.fillRect(QRect(QPoint(0, 0), pixels), Qt::white);
    painter.scale(scale, scale);
    QFont font = headingFont();
    font.setPixelSize(static_cast<int>(width * fileTextShare));
    paintFile(painter, QRectF(0, 0, width, pixels.height() / scale), font);
}

QImage FileChart::image(const QSize& pixels) const {
    QImage picture(pixels, QImage::Format_RGB32);
    QPainter painter(&picture);
    paintPage(painter, pixels);
    return picture;
}

QByteArray FileChart::svg(const QSize& size) const {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    // Qt 6.4 writes a title as it is given.
    generator.setTitle(fileTitle().toHtmlEscaped());
    QPainter painter(&generator);
    paintPage(painter, size);
    painter.end();
    return buffer.data();
}

}  // namespace rubble::widgets
