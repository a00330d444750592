#pragma once

#include <QString>

class QFormLayout;
class QWidget;

namespace rubble::widgets {

/// Adds an editor with its name before it; the name leads to it by its mnemonic, and both say the same on hover.
void addRow(QFormLayout& form, const QString& name, QWidget* editor, const QString& tip);

}  // namespace rubble::widgets
