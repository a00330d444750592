#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/gui/session/kept_runs.h"

class QWidget;

namespace rubble {

class Session;
namespace widgets {
class KeptRunsDialog;
}

/// Lists the kept runs of all cases in a dialog, opens and removes them.
class KeptRunsDisplay : public QObject {
    Q_OBJECT

public:
    KeptRunsDisplay(Session& session, QWidget& window, QObject* parent = nullptr);
    ~KeptRunsDisplay() override;

    /// Opens the list, or brings it to the front.
    void show();
    /// Shows a run file, wherever it lies, in the case that it belongs to.
    void openFile(const QString& path);

signals:
    /// A case is wanted, one of whose runs is to be shown then.
    void openRequested(const QString& path);

private:
    std::vector<RunFolder> folders() const;
    QStringList inUse() const;
    void refresh();
    void open(const QString& path);
    void await(const KeptRunFile& run);
    void showAwaited();
    void remove(const QStringList& paths);
    void undo();
    void close();

    Session& m_session;
    QWidget& m_window;
    QPointer<widgets::KeptRunsDialog> m_dialog;
    std::vector<KeptRunFile> m_runs;
    QStringList m_aside;                   ///< removed since the list was opened
    std::optional<KeptRunFile> m_awaited;  ///< that is shown once its case is open
};

}  // namespace rubble
