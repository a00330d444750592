#include "widgets/basics/form_row.h"

#include <QFormLayout>
#include <QLabel>

namespace rubble::widgets {

void addRow(QFormLayout& form, const QString& name, QWidget* editor, const QString& tip) {
    auto* label = new QLabel(name);
    label->setBuddy(editor);
    label->setToolTip(tip);
    editor->setToolTip(tip);
    editor->setAccessibleName(name);
    form.addRow(label, editor);
}

}  // namespace rubble::widgets
