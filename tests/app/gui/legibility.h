#pragma once

#include <QStringList>

class QWidget;

namespace rubble {

/// What of a window cannot be read whole, one line each with the place and the text: texts wider or higher than the widget that
/// shows them, widgets that reach out of the one they stand in, texts that lie over each other. What a scroll area brings into
/// sight is in sight; text that says by a tip what it had to leave out is whole.
QStringList illegibleIn(const QWidget& window);

}  // namespace rubble
