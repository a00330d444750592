#pragma once

#include <QIcon>
#include <QPainter>

namespace rubble::widgets {

/// Line icons drawn by the program itself, so that they follow the theme and scale to any display.
enum class Glyph {
    Case,
    Fragments,
    Grid,
    Effects,
    Run,
    Accuracy,
    Evidence,
    Report,
    Open,
    Save,
    Undo,
    Redo,
    Play,
    Pause,
    First,
    Last,
    Back,
    Forward,
    Beside,
    Stacked,
    FeOnly,
    FragmentsOnly,
    Link,
    Fit,
    Live,
    Stop,
    PlayBack,
    Loop,
    Bookmark,
    Unfold,
    Fold,
    Close,
    Float,
    Reset,
    Help
};

/// Draws a glyph into a square with the painter's pen colour.
void drawGlyph(QPainter& painter, Glyph glyph, const QRectF& square);
/// The warning sign: a filled triangle with an exclamation mark, 14 px high, around a point.
void drawWarning(QPainter& painter, const QPointF& centre, const QColor& colour, const QColor& mark);
/// The glyph as an icon in the text colour of the theme in force.
QIcon glyphIcon(Glyph glyph);

}  // namespace rubble::widgets
