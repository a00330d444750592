#pragma once

#include <QPen>
#include <QString>

#include "core/evidence/maps/debris_map.h"
#include "widgets/figures/map_picture.h"
#include "widgets/figures/palette.h"

namespace rubble::figures {

/// Name of a layer of a map as people read it.
QString layerName(const DebrisMap& map, MapLayer layer);

/// What stands above the colours of a layer: short, since little room is beside a map, whose caption says it in full.
QString legendTitle(const DebrisMap& map, MapLayer layer);

/// What a unit of a layer is divided by where its numbers grow too long to be read.
double unitScale(MapLayer layer);
/// That unit; empty for a number of things.
QString unitText(MapLayer layer);

/// A number of a legend, without powers of ten where thousands will do.
QString legendNumber(double value);

/// How much debris lies on a map of one run: fragments, mass, footprint by its cells, mean height of the highest of them.
QString debrisSums(const DebrisMap& map);
/// What a line on a map is, for its legend, and how it is drawn.
QString outlineWords(MapOutline::Of of);
QPen lineOf(MapOutline::Of of, const Palette& palette, double width);

}  // namespace rubble::figures
