#include "widgets/evidence/sealing/signer_form.h"

#include <QFormLayout>
#include <QLineEdit>

#include "widgets/basics/form_row.h"
#include "widgets/evidence/sealing/file_field.h"

namespace rubble::widgets {

SignerForm::SignerForm(QFormLayout& form, const QString& prefix, const QString& by, const QString& byTip, QObject* parent)
    : QObject(parent),
      m_by(new QLineEdit),
      m_key(new FileField(qPrintable(prefix + QStringLiteral("Key")), tr("Key"))),
      m_certificate(new FileField(qPrintable(prefix + QStringLiteral("Certificate")), tr("Certificate"))),
      m_passphrase(new QLineEdit) {
    m_by->setObjectName(prefix + QStringLiteral("By"));
    m_passphrase->setObjectName(prefix + QStringLiteral("Passphrase"));
    m_passphrase->setEchoMode(QLineEdit::Password);
    addRow(form, by, m_by, byTip);
    addRow(form, tr("Key"), m_key, tr("Private key of whoever signs, PEM: Ed25519, RSA or elliptic curve"));
    addRow(form, tr("Certificate"), m_certificate,
           tr("X.509 certificate of that key, which says a name. Without it the other side compares the SHA-256 of the key."));
    addRow(form, tr("Passphrase"), m_passphrase, tr("Passphrase of the key, if it has one; it is kept nowhere"));
    for (const QLineEdit* line : {m_by, m_passphrase}) {
        connect(line, &QLineEdit::textChanged, this, &SignerForm::changed);
    }
    for (const FileField* file : {m_key, m_certificate}) {
        connect(file, &FileField::changed, this, &SignerForm::changed);
    }
}

SignerChoice SignerForm::choice() const {
    return {m_by->text().trimmed(), m_key->path(), m_certificate->path(), m_passphrase->text()};
}

void SignerForm::setChoice(const SignerChoice& choice) {
    m_by->setText(choice.by);
    m_key->setPath(choice.key);
    m_certificate->setPath(choice.certificate);
}

void SignerForm::forgetPassphrase() {
    m_passphrase->clear();
}

}  // namespace rubble::widgets
