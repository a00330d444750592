#pragma once

#include <QString>

#include <optional>

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/panes.h"

class QPainter;

namespace rubble::figures {

enum class Corner { UpperRight, UpperLeft, LowerRight, LowerLeft };

/// Paints what a view marks in a pane: lengths with their labels in m, the way of a fragment from its birth to its end, the
/// directions of the axes. The painter works in device pixels.
/// @param textHeight  of the font, device pixels
/// @param axes        where these directions stand; nothing: they are left out
void paintMarks(QPainter& painter, const render::View& view, const render::Pane& pane, double textHeight,
                std::optional<Corner> axes = Corner::UpperRight);

/// What the directions of the axes take of a corner along each of its sides, device pixels.
double axesRoom(double textHeight);

/// The first corner of a pane where the directions of the axes cover nothing of a box; nothing if there is none.
std::optional<Corner> axesCorner(const render::View& view, const render::Pane& pane, const Aabb& box, double textHeight);

/// A measured length for people: "12.34 m", to the centimetre below 100 m and to the decimetre above.
QString measuredText(double length);

}  // namespace rubble::figures
