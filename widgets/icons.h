#pragma once

#include <QIcon>
#include <QPainter>

namespace rubble::widgets {

/// Line icons drawn by the program itself, so that they follow the theme and scale to any display.
enum class Glyph {
    Case,
    Fragments,
    Grid,
    Run,
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
    Help
};

/// Draws a glyph into a square with the painter's pen colour.
void drawGlyph(QPainter& painter, Glyph glyph, const QRectF& square);
/// The glyph as an icon in the text colour of the theme in force.
QIcon glyphIcon(Glyph glyph);

}  // namespace rubble::widgets
