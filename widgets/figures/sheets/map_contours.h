#pragma once

#include <QPen>
#include <QPointF>
#include <QRectF>

#include <functional>

#include "core/evidence/maps/debris_map.h"

class QPainter;

namespace rubble::figures {

/// How lines of equal height are drawn.
struct ContourStyle {
    double spacing = 0.5;                                  ///< m, between them
    QRectF frame;                                          ///< px, of the map
    std::function<QPointF(const Eigen::Vector2d&)> pixel;  ///< of a place, m, local
    QPen pen;                                              ///< of lines with a number
    double text = 10.0;                                    ///< px, of the numbers
};

/// Whether a map has heights for such lines.
bool hasContours(const DebrisMap& map, double spacing);

/// Every how many lines one has a number: at most five levels have it each, of more every whole number of metres or so.
int numberedEvery(double spacing, double highest);

/// Draws lines of equal height of the debris. Those with a number are stronger; it stands once for each level, where there is room,
/// in the chosen unit of length. Throws as heightContours().
void drawContours(QPainter& painter, const DebrisMap& map, const ContourStyle& style);

}  // namespace rubble::figures
