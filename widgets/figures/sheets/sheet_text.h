#pragma once

#include <QFont>
#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QString>

namespace rubble::figures {

/// The font of text on a sheet. @param pixels  its height, at least 5
QFont sheetFont(double pixels, bool italic = false);

/// One line of text in a box. @param alignment  of Qt::Alignment
void writeLine(QPainter& painter, const QRectF& box, const QString& text, int alignment, const QFont& font, const QColor& colour);

/// Letters of a text that has to be read whole.
struct WholeText {
    double largest = 0.0;   ///< px, height of the letters
    double smallest = 0.0;  ///< px
    bool italic = false;
};
/// Text in a box, whole: over several lines and in smaller letters rather than cut. In the colour of the pen.
/// @param alignment  of Qt::Alignment
void writeWhole(QPainter& painter, const QRectF& box, const QString& text, int alignment, const WholeText& letters);

/// What an image file says of its resolution, dots an inch.
void setResolution(QImage& image, double dpi);

}  // namespace rubble::figures
