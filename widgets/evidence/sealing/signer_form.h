#pragma once

#include <QObject>
#include <QString>

class QFormLayout;
class QLineEdit;

namespace rubble::widgets {

class FileField;

/// Who signs, and with what.
struct SignerChoice {
    QString by;
    QString key;          ///< file
    QString certificate;  ///< file; empty: the key alone
    QString passphrase;   ///< of the key; empty: it has none
};

/// Rows of a form that ask who signs. What is typed as a passphrase is shown as dots and kept nowhere.
class SignerForm : public QObject {
    Q_OBJECT

public:
    /// @param prefix  of the names of its fields: "seal" for sealBy, sealKey, sealCertificate, sealPassphrase
    /// @param by      what the first row is called
    SignerForm(QFormLayout& form, const QString& prefix, const QString& by, const QString& byTip, QObject* parent);

    SignerChoice choice() const;
    /// All but the passphrase.
    void setChoice(const SignerChoice& choice);
    void forgetPassphrase();

signals:
    void changed();

private:
    QLineEdit* m_by;
    FileField* m_key;
    FileField* m_certificate;
    QLineEdit* m_passphrase;
};

}  // namespace rubble::widgets
