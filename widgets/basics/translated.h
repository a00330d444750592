#pragma once

#include <QCoreApplication>
#include <QString>

namespace rubble::widgets {

/// A text of a function that belongs to no class, in the language that is spoken.
inline QString tr(const char* text) {
    return QCoreApplication::translate("rubble::widgets", text);
}

}  // namespace rubble::widgets
