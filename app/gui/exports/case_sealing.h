#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "io/seal/seal_offer.h"
#include "widgets/evidence/sealing/seal_dialog.h"

class QWidget;

namespace rubble {

class Actions;
class FileCommands;
class ReportWork;
class Session;

/// Seals the case that is open into a bundle, with what the user chooses of it, on the worker.
class CaseSealing : public QObject {
    Q_OBJECT

public:
    CaseSealing(Session& session, FileCommands& files, Actions& actions, QWidget& window);
    /// Knows what a report is asked to say.
    void setReport(ReportWork& report) { m_report = &report; }

    /// Saves the case, looks for what it has, and asks what of it is sealed and by whom.
    void seal();

private:
    /// What was chosen last, but for the passphrase.
    struct LastSeal {
        QString note;
        bool stampRequest = false;
        bool report = false;  ///< one was made of a run that had none
        bool page = false;
    };
    void ask(const std::vector<io::OfferedPart>& offer);
    QString askForBundle();
    /// What the window has of the case and nobody kept: the run that is shown.
    void addShownRun(std::vector<io::OfferedPart>& offer) const;
    void sealAt(const QString& path, const widgets::SealChoice& choice);
    /// @param made  reports and pages that were made to be sealed
    void tell(const QString& path, const io::SealReport& report, const std::vector<io::SealedExtra>& made);

    Session& m_session;
    FileCommands& m_files;
    QWidget& m_window;
    ReportWork* m_report = nullptr;
};

}  // namespace rubble
