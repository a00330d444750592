#pragma once

#include <QString>

class QDialog;
class QFormLayout;
class QLineEdit;
class QVBoxLayout;
class QWidget;

namespace rubble::widgets {

/// Adds an editor with its name before it; the name leads to it by its mnemonic, and both say the same on hover.
void addRow(QFormLayout& form, const QString& name, QWidget* editor, const QString& tip);

/// The column of a dialog, with the distances that all of them have.
QVBoxLayout* dialogColumn(QDialog& dialog);
/// A form as it stands in dialogs, still without a place.
QFormLayout* dialogForm();

/// What is typed into a line counts at once, without Enter: who leaves it by Esc leaves it as it is.
void keepAsTyped(QLineEdit& line);
bool isKeptAsTyped(const QLineEdit& line);

}  // namespace rubble::widgets
