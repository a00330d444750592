#pragma once

#include <QColor>
#include <QFont>

#include "widgets/figures/palette.h"
#include "widgets/render/view.h"

namespace rubble::widgets {

/// The theme that the system's palette asks for; settled once, before the program gives itself a palette.
render::Theme systemTheme();
/// Gives palette, fonts and style sheet of a theme to the whole application (Theme::Print is taken as light).
void applyTheme(render::Theme theme);
/// The theme in force, and its colours.
render::Theme currentTheme();
const figures::Palette& tints();

/// The interface font at one of the three sizes: panel title, text, small heading; and large figures for the time.
QFont titleFont();
QFont textFont();
QFont headingFont();
/// The small heading of a group, in capitals where the script has them.
QFont groupFont();
QFont largeFigureFont();

}  // namespace rubble::widgets
