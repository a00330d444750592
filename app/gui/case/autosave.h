#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/gui/session/worker.h"
#include "core/scenario/case.h"

namespace rubble {

class Document;

/// Work that a program left behind which ended without being asked to. Held by a lock, so that no second window offers it too.
struct LeftWork {
    QString file;  ///< in the state folder
    Case theCase;
    QString path;  ///< of the case; empty if it was never saved
    QString base;
    QDateTime savedAt;
    std::shared_ptr<QLockFile> lock;
};

/// Keeps changes that are not saved in the user's state folder, in a file of this program's own, until they are saved or given up.
/// A program that is killed leaves its file and a lock that nobody holds; the next one finds both.
class Autosave : public QObject {
    Q_OBJECT

public:
    static constexpr int defaultInterval = 60;  ///< s
    /// Seconds between two autosaves as the user has set it; 0: off.
    static int chosenInterval();

    /// @param folder  made when it is needed; empty: nothing is kept
    Autosave(Document& document, const QString& folder, QObject* parent = nullptr);
    /// Ended in good order: what was to be kept has been saved or given up.
    ~Autosave() override;

    /// s; 0: off.
    void setInterval(int seconds);
    /// Writes what is not saved, now.
    void saveNow();
    /// What other programs left behind, newest first. Files that cannot be read are set aside, which set() tells.
    std::vector<LeftWork> leftWork();
    /// Removes what was left behind.
    static void remove(const LeftWork& work);
    /// Where the changes of this program are kept; empty while there are none.
    const QString& file() const { return m_file; }

signals:
    void failed(const rubble::Failure& failure);
    /// A damaged file was set aside. @param where  it is now
    void setAside(const rubble::Failure& what, const QString& where);

private:
    void changed();
    void clear();
    bool claimFile();

    Document& m_document;
    QString m_folder;
    QString m_file;
    QTimer m_timer;
    std::unique_ptr<QLockFile> m_lock;
    bool m_told = false;  // that it cannot be written
};

/// Moves a file that cannot be read out of the way, beside itself; gives its new name, empty if that failed.
QString setFileAside(const QString& path);

}  // namespace rubble
