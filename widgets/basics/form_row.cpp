#include "widgets/basics/form_row.h"

#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace rubble::widgets {

namespace {

constexpr const char* keptAsTyped = "rubbleKeptAsTyped";

}  // namespace

void addRow(QFormLayout& form, const QString& name, QWidget* editor, const QString& tip) {
    auto* label = new QLabel(name);
    label->setBuddy(editor);
    label->setToolTip(tip);
    editor->setToolTip(tip);
    editor->setAccessibleName(name);
    form.addRow(label, editor);
}

QVBoxLayout* dialogColumn(QDialog& dialog) {
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(12);
    return column;
}

QFormLayout* dialogForm() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    return form;
}

void keepAsTyped(QLineEdit& line) {
    line.setProperty(keptAsTyped, true);
}

bool isKeptAsTyped(const QLineEdit& line) {
    return line.property(keptAsTyped).toBool();
}

}  // namespace rubble::widgets
