#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>

class QPainter;

namespace rubble::widgets {

/// A short text on a ground of its own, legible on any picture.
/// @param corner  its upper left or right one, by `side`
void paintChip(QPainter& painter, const QString& text, const QPointF& corner, Qt::Alignment side);

/// The mark of a point pair, alike in photograph and model: a cross with a white rim and its number. One that looks wrong has
/// another colour, a ring and an exclamation mark.
void paintPointMark(QPainter& painter, const QPointF& at, std::size_t number, bool used, bool chosen);
/// A point that was clicked and waits for its counterpart.
void paintPendingPoint(QPainter& painter, const QPointF& at);
/// A cross with a rim. @param arm  px
void paintCross(QPainter& painter, const QPointF& at, const QColor& colour, const QColor& rim, double arm, double wide);

/// How many times as large a loupe shows things, and its radius, px.
inline constexpr double loupeScale = 4.0;
inline constexpr double loupeRadius = 64.0;
/// Where the loupe of a place stands: beside it, and within the widget.
QPointF loupeMiddle(const QRectF& widget, const QPointF& at);
/// Draws a round loupe beside a place: what `content` draws around it, larger, with a cross in its middle.
/// @param content  draws in coordinates of the widget
void paintLoupe(QPainter& painter, const QRectF& widget, const QPointF& at, const std::function<void(QPainter&)>& content);

}  // namespace rubble::widgets
