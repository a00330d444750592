#pragma once

#include <QObject>
#include <QString>

#include "widgets/evidence/seal_dialog.h"

class QWidget;

namespace rubble {

class Actions;
class FileCommands;
class Session;

/// Seals the case that is open into a bundle, and opens bundles that others sealed: both on the worker.
class CaseSealing : public QObject {
    Q_OBJECT

public:
    CaseSealing(Session& session, FileCommands& files, Actions& actions, QWidget& window);

    /// Seals the case as it was saved, with its run if one with its settings is complete.
    void sealAt(const QString& path, const widgets::SealChoice& choice);
    /// Asks for a folder to unpack a bundle into, and opens it.
    void openBundle(const QString& bundle);
    /// Checks a bundle, unpacks it into an empty folder, simulates its runs again, and says what came of it.
    void openAt(const QString& bundle, const QString& folder);

signals:
    /// A bundle is as it was sealed: this is the copy of its case to work on.
    void opened(const QString& casePath);

private:
    /// What was chosen last, but for the passphrase.
    struct LastSeal {
        widgets::SealChoice choice;
    };
    void seal();
    void open();

    Session& m_session;
    FileCommands& m_files;
    QWidget& m_window;
};

}  // namespace rubble
