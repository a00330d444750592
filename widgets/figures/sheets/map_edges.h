#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

#include <vector>

#include "core/fe/control_points.h"

class QPainter;

namespace rubble::figures {

/// A coordinate at the edge of a map.
struct EdgeTick {
    double at = 0.0;  ///< share of the edge from its start
    QString text;
};

/// The coordinates along an edge of a map: of easting and northing that which changes more from one end to the other, at multiples
/// of a step; in a map that is turned they say which of them it is.
/// @param from  m, local, as `to`; @param step  m
std::vector<EdgeTick> edgeTicks(const SiteFit& site, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double step);

/// A map on a sheet, its local x to the right.
struct MapEdges {
    QRectF frame;                                    ///< px
    Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< m, local, of the lower left corner
    Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< m, local, of the upper right corner
    double across = 0.0;                             ///< m, between coordinates along the lower edge
    double up = 0.0;                                 ///< m, along the left edge
};

/// The step along the lower edge, doubled until there is room for its numbers: a long and narrow map would have too many.
/// @param metres  m, that a pixel covers; @param small  px, of the text
double stepAcross(double step, double metres, double small);

/// Writes the coordinates below and to the left of a map. @param unit  that the site and the steps count in
/// @param small  px, of the text
void drawCoordinates(QPainter& painter, const MapEdges& edges, const SiteFit& site, const QString& unit, double small,
                     const QColor& line, const QColor& text);

}  // namespace rubble::figures
