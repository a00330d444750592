#pragma once

#include <QRectF>
#include <QString>

class QColor;
class QPainter;

namespace rubble::figures {

/// What stands above a map: what it is of, and below that what lies there in numbers. Both are read whole.
struct MapHead {
    QString subject;  ///< empty: no head
    QString sums;     ///< empty: none

    /// Room that it takes, px. @param width  px that its lines have  @param text  px, height of its letters
    double height(double width, double text) const;
    /// @param box  of that width and height
    void paint(QPainter& painter, const QRectF& box, double text, const QColor& colour) const;
};

}  // namespace rubble::figures
