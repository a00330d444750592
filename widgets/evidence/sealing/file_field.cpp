#include "widgets/evidence/sealing/file_field.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace rubble::widgets {

FileField::FileField(const char* name, const QString& label, QWidget* parent) : QWidget(parent), m_line(new QLineEdit) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    m_line->setObjectName(QLatin1String(name));
    m_line->setAccessibleName(label);
    auto* browse = new QPushButton(tr("Choose…"));
    browse->setAutoDefault(false);
    browse->setAccessibleName(tr("Choose the file: %1").arg(label));
    row->addWidget(m_line, 1);
    row->addWidget(browse);
    setFocusProxy(m_line);
    connect(m_line, &QLineEdit::textChanged, this, &FileField::changed);
    connect(browse, &QPushButton::clicked, this, [this, label] {
        const QString chosen = QFileDialog::getOpenFileName(this, label, QFileInfo(path()).absolutePath(), tr("All files (*)"));
        if (!chosen.isEmpty()) {
            setPath(chosen);
        }
    });
}

QString FileField::path() const {
    return m_line->text().trimmed();
}

void FileField::setPath(const QString& path) {
    m_line->setText(path);
}

}  // namespace rubble::widgets
