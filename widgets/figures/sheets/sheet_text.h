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

/// What an image file says of its resolution, dots an inch.
void setResolution(QImage& image, double dpi);

}  // namespace rubble::figures
