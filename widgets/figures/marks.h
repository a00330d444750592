#pragma once

#include <QString>

#include "widgets/render/panes.h"
#include "widgets/render/view.h"

class QPainter;

namespace rubble::figures {

/// Paints what a view marks in a pane: lengths with their labels in m, the way of a fragment from its birth to its end, the
/// directions of the axes. The painter works in device pixels.
/// @param textHeight  of the font, device pixels
void paintMarks(QPainter& painter, const render::View& view, const render::Pane& pane, double textHeight);

/// A measured length for people: "12.34 m", to the centimetre below 100 m and to the decimetre above.
QString measuredText(double length);

}  // namespace rubble::figures
