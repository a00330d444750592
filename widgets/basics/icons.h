#pragma once

#include <QIcon>
#include <QPainter>

namespace rubble::widgets {

/// Signs in the colours of our theme, at any size: those of the installed icon theme by their standard names, and drawings of our
/// own (`resources/icons`) for what only Rubble knows.
enum class Glyph {
    Case,
    Fragments,
    Grid,
    Effects,
    Run,
    Accuracy,
    Finding,
    Evidence,
    Report,
    New,
    Open,
    Refresh,
    Duplicate,
    Save,
    SaveAs,
    Quit,
    Undo,
    Redo,
    Preferences,
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
    Help,
    Search,
    About
};

/// Takes signs from Breeze, where it is not installed from the icon theme of the desktop. What Qt itself shows (signs of messages
/// and of their buttons) comes from there too.
void useIconTheme(bool dark);
/// Draws a glyph into a square with the painter's pen colour; nothing where no theme has it.
void drawGlyph(QPainter& painter, Glyph glyph, const QRect& square);
/// The glyph as an icon in the text colour of the theme in force.
QIcon glyphIcon(Glyph glyph);

}  // namespace rubble::widgets
