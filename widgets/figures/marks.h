#pragma once

#include <QString>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "widgets/render/basics/camera.h"
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

/// The first corner of a pane where the directions of the axes cover nothing; nothing if there is none, or the pane is too small.
/// @param covered  of rectangles of pixels (left, top, right, bottom), whether something lies in them
std::optional<Corner> axesCorner(const render::Pane& pane, double textHeight,
                                 const std::function<std::vector<bool>(std::span<const std::array<double, 4>>)>& covered);

/// Where a camera looks: "looking north-east (47°)" clockwise from north, "looking 58° from x towards y" where north is not known.
/// @param north  as northOf()
QString lookingText(const render::Camera& camera, std::optional<double> north);

/// A measured length for people: "12.34 m", to the centimetre below 100 m and to the decimetre above.
QString measuredText(double length);

}  // namespace rubble::figures
