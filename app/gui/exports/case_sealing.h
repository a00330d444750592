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
class Session;

/// Seals the case that is open into a bundle, with what the user chooses of it, on the worker.
class CaseSealing : public QObject {
    Q_OBJECT

public:
    CaseSealing(Session& session, FileCommands& files, Actions& actions, QWidget& window);

    /// Saves the case, looks for what it has, and asks what of it is sealed and by whom.
    void seal();

private:
    /// What was chosen last, but for the passphrase.
    struct LastSeal {
        QString note;
        bool stampRequest = false;
    };
    void ask(const std::vector<io::OfferedPart>& offer);
    QString askForBundle();
    /// What the window has of the case and nobody kept: the run that is shown.
    void addShownRun(std::vector<io::OfferedPart>& offer) const;
    void sealAt(const QString& path, const widgets::SealChoice& choice);
    void tell(const QString& path, const io::SealReport& report);

    Session& m_session;
    FileCommands& m_files;
    QWidget& m_window;
};

}  // namespace rubble
