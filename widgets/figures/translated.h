#pragma once

#include <QCoreApplication>

namespace rubble::figures {

/// Words of a figure in the language of the program.
inline QString tr(const char* text) {
    return QCoreApplication::translate("rubble::figures", text);
}

}  // namespace rubble::figures
