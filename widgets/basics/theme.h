#pragma once

#include <QColor>
#include <QFont>
#include <QString>

#include "widgets/figures/palette.h"
#include "widgets/render/basics/view.h"

namespace rubble::widgets {

/// The theme that the system's palette asks for; settled once, before the program gives itself a palette.
render::Theme systemTheme();
/// The theme that a name stands for: "light", "dark", anything else is the system's.
render::Theme themeNamed(const QString& name);
/// Gives style and palette of a theme to the whole application (Theme::Print is taken as light), unless it has them.
void giveColours(render::Theme theme);
/// Gives it the style sheet too. A sheet is matched against every widget that there is, and against each that is put into another
/// from then on: a window gets it once, when it has all of its widgets.
void applyTheme(render::Theme theme);
/// Takes the sheet off until the next applyTheme(), while a window is made.
void takeOffSheet();
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
