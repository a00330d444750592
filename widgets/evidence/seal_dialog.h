#pragma once

#include <QDialog>

class QFormLayout;
class QLineEdit;
class QPushButton;

namespace rubble::widgets {

/// Who seals a case, and with what.
struct SealChoice {
    QString by;
    QString note;
    QString key;          ///< file
    QString certificate;  ///< file; empty: the key alone
    QString passphrase;   ///< of the key; empty: it has none
};

/// Asks who seals a case and with which key. What is typed as a passphrase is shown as dots and kept nowhere.
class SealDialog : public QDialog {
    Q_OBJECT

public:
    explicit SealDialog(const SealChoice& choice, QWidget* parent = nullptr);

    SealChoice choice() const;

private:
    QLineEdit* addFile(QFormLayout& form, const char* name, const QString& label, const QString& tip);
    void showReady();

    QLineEdit* m_by;
    QLineEdit* m_note;
    QLineEdit* m_key = nullptr;
    QLineEdit* m_certificate = nullptr;
    QLineEdit* m_passphrase;
    QPushButton* m_seal = nullptr;
};

}  // namespace rubble::widgets
