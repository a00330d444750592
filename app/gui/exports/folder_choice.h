#pragma once

#include <QString>

class QWidget;

namespace rubble {

/// Asks for a folder to write into: one that is there, or the name of a new one. Whoever writes makes it, so a cancel leaves
/// nothing behind. A name that cannot be made is refused with the reason. Empty: none was chosen.
QString chooseFolder(QWidget& parent, const QString& title, const QString& beside);

}  // namespace rubble
