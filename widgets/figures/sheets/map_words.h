#pragma once

#include <QPen>
#include <QString>

#include "core/evidence/maps/debris_map.h"
#include "widgets/figures/map_picture.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {

/// Name of a layer of a map as people read it.
QString layerName(const DebrisMap& map, MapLayer layer);

/// What stands above the colours of a layer: short, since little room is beside a map, whose caption says it in full.
QString legendTitle(const DebrisMap& map, MapLayer layer);

/// By which a value of a layer is multiplied to be shown: in the chosen units, or larger where numbers grow too long to be read.
double shownScale(MapLayer layer);
/// The unit that it is then in; empty for a number of things.
QString unitText(MapLayer layer);

/// What coordinates along the edges count in: those of a system stay what they are in it, those of the model count as lengths do.
ShownUnit coordinateUnit(const MapPictureStyle& style);
/// Between coordinates: round in that unit, at most so many pixels long. @param metres  that a pixel covers
double coordinateStep(const MapPictureStyle& style, double metres, double pixels);
/// The system they are of, or that they are those of the model.
QString coordinatesWords(const MapPictureStyle& style);

/// A number of a legend, without powers of ten where thousands will do.
QString legendNumber(double value);

/// How much debris lies on a map of one run: fragments, mass, footprint by its cells, mean height of the highest of them.
QString debrisSums(const DebrisMap& map);
/// A place of a map in words: its coordinates, the value of the layer there, and the height where that is another one.
/// @param place  m, local
QString placeWords(const DebrisMap& map, MapLayer layer, const MapPictureStyle& style, const Eigen::Vector2d& place);
/// What a line on a map is, for its legend, and how it is drawn.
QString outlineWords(MapOutline::Of of);
QPen lineOf(MapOutline::Of of, const Palette& palette, double width);

}  // namespace rubble::figures
