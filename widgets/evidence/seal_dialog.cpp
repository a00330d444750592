#include "widgets/evidence/seal_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/form_row.h"

namespace rubble::widgets {

SealDialog::SealDialog(const SealChoice& choice, QWidget* parent)
    : QDialog(parent), m_by(new QLineEdit(choice.by)), m_note(new QLineEdit(choice.note)), m_passphrase(new QLineEdit) {
    setWindowTitle(tr("Seal the case"));
    setObjectName(QStringLiteral("sealDialog"));
    m_by->setObjectName(QStringLiteral("sealBy"));
    m_note->setObjectName(QStringLiteral("sealNote"));
    m_passphrase->setObjectName(QStringLiteral("sealPassphrase"));
    m_passphrase->setEchoMode(QLineEdit::Password);
    auto* column = dialogColumn(*this);
    auto* form = dialogForm();
    addRow(*form, tr("Sealed by"), m_by, tr("Who seals the case"));
    addRow(*form, tr("Note"), m_note, tr("Why, or what is to be known of it"));
    m_key = addFile(*form, "sealKey", tr("Key"), tr("Private key of whoever signs, PEM: Ed25519, RSA or elliptic curve"));
    m_certificate = addFile(*form, "sealCertificate", tr("Certificate"), tr("X.509 certificate of that key, if there is one"));
    addRow(*form, tr("Passphrase"), m_passphrase, tr("Passphrase of the key, if it has one; it is kept nowhere"));
    m_key->setText(choice.key);
    m_certificate->setText(choice.certificate);
    column->addLayout(form);
    auto* about =
        new QLabel(tr("The case is packed with its journal, its inputs and the run that is shown. Whoever opens the bundle "
                      "sees whether anything was altered since."));
    about->setObjectName(QStringLiteral("muted"));
    about->setWordWrap(true);
    column->addWidget(about);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_seal = buttons->addButton(tr("Seal…"), QDialogButtonBox::AcceptRole);
    m_seal->setObjectName(QStringLiteral("sealAccept"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_key, &QLineEdit::textChanged, this, &SealDialog::showReady);
    setMinimumWidth(480);
    showReady();
}

QLineEdit* SealDialog::addFile(QFormLayout& form, const char* name, const QString& label, const QString& tip) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    auto* field = new QLineEdit;
    field->setObjectName(QLatin1String(name));
    auto* browse = new QPushButton(tr("Choose…"));
    browse->setAccessibleName(tr("Choose the file: %1").arg(label));
    line->addWidget(field, 1);
    line->addWidget(browse);
    row->setFocusProxy(field);
    addRow(form, label, row, tip);
    field->setAccessibleName(label);
    connect(browse, &QPushButton::clicked, this, [this, field, label] {
        const QString path =
            QFileDialog::getOpenFileName(this, label, QFileInfo(field->text()).absolutePath(), tr("PEM files (*)"));
        if (!path.isEmpty()) {
            field->setText(path);
        }
    });
    return field;
}

void SealDialog::showReady() {
    m_seal->setEnabled(!m_key->text().trimmed().isEmpty());
}

SealChoice SealDialog::choice() const {
    return {m_by->text().trimmed(), m_note->text().trimmed(), m_key->text().trimmed(), m_certificate->text().trimmed(),
            m_passphrase->text()};
}

}  // namespace rubble::widgets
