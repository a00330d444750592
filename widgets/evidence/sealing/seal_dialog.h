#pragma once

#include <QDialog>
#include <functional>
#include <vector>

#include "widgets/evidence/sealing/signer_form.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace rubble::widgets {

class Notice;

/// Something that can be sealed with a case.
struct SealPart {
    enum class Kind { Input, Run, Export, Report, Page };
    Kind kind = Kind::Input;
    QString id;  ///< of an input; of a run the name of its scenario
    QString path;
    QString remark;  ///< what speaks against it; empty: nothing
    qint64 bytes = 0;
    bool chosen = true;  ///< of an input: it travels, and not its digest alone
    QString run = {};    ///< of a report or a page that is made before it is sealed: the file of its run
};

/// What is sealed, and by whom.
struct SealChoice {
    SignerChoice signer;
    QString note;
    bool stampRequest = false;    ///< a request for a time stamp is written, to be answered later
    std::vector<SealPart> parts;  ///< besides the case with its journal
};

/// Why something cannot be done, and what to do about it.
struct SealObjection {
    QString what;  ///< empty: it can
    QString remedy;
};

/// Asks what of a case is sealed, who seals it and with which key.
class SealDialog : public QDialog {
    Q_OBJECT

public:
    explicit SealDialog(const SealChoice& choice, QWidget* parent = nullptr);

    SealChoice choice() const;
    /// @param part  says what a file or folder is that was chosen to be added, and what can be made of it
    void setAdding(std::function<std::vector<SealPart>(const QString& path)> part) { m_part = std::move(part); }
    /// @param objection  asked before the dialog is accepted, for keys that cannot be used
    void setCheck(std::function<SealObjection(const SealChoice& choice)> objection) { m_objection = std::move(objection); }

    void accept() override;

private:
    QWidget* buildParts();
    void buildSigner(QVBoxLayout& column, const SealChoice& choice);
    QTreeWidgetItem* groupOf(SealPart::Kind kind);
    void addPart(const SealPart& part);
    void addFiles();
    void addFolder();
    /// Size of all that is ticked, what of an input is left, and what cannot be made as its run stays.
    void showChosen();
    QString remarkOf(const SealPart& part, bool stays) const;
    /// The run of something that is to be made is not sealed.
    bool runStays(const SealPart& part) const;
    void showReady();

    std::function<std::vector<SealPart>(const QString& path)> m_part;
    std::function<SealObjection(const SealChoice& choice)> m_objection;
    std::vector<SealPart> m_parts;
    QTreeWidget* m_tree;
    QLabel* m_sum;
    SignerForm* m_signer = nullptr;
    QLineEdit* m_note;
    QCheckBox* m_stamp;
    Notice* m_notice;
    QPushButton* m_seal = nullptr;
};

}  // namespace rubble::widgets
