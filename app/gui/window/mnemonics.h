#pragma once

class QMenu;
class QMenuBar;

namespace rubble {

/// Gives every title of a menu bar a letter for the keyboard, unique in the bar: one of its own where the script is Latin, else one
/// in brackets behind it, as is the custom.
void giveMnemonics(QMenuBar& bar);
/// The same for the actions of a menu and of the menus in it; done whenever a menu opens, because some actions change their text.
void giveMnemonics(QMenu& menu);

}  // namespace rubble
