#pragma once

#include <QString>
#include <QStringList>

namespace rubble {

/// First word of the command line that makes the test program a session that is left open to be killed.
inline const QString leftSessionWord = QStringLiteral("--leave-session");

/// A session of the window: opens a file, changes a setting, and goes on until something ends it. Autosaves every second.
/// @param words  the file, then key=value
int leaveSession(const QStringList& words);

}  // namespace rubble
