#pragma once

#include <QString>
#include <QStringList>
#include <map>

class QWidget;

namespace rubble {

class FeResult;

/// Text by the place where it stands: the way down from the window, and which property.
using Texts = std::map<QString, QString>;

/// All that a window says, on screen or when asked (tips, names for screen readers), but what the user typed.
Texts textsOf(QWidget& window);
/// English words in a text, but for names and what is the same in every language.
QStringList strangeWords(QString text, const QStringList& names);
/// Names that a file and the program's build bring along; the file may be null.
QStringList namesIn(const FeResult* fe);

}  // namespace rubble
