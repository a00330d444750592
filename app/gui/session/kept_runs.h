#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/pipeline/run_entry.h"

class QLockFile;

namespace rubble {

class FeResult;

/// Where the next run file of a folder is written.
QString newRunFile(const QString& folder);

/// Held while a file or folder is in use: the system frees it when its program dies.
/// @return null if another program that lives holds it
std::unique_ptr<QLockFile> holdFile(const QString& path);

/// What a run file tells of a run that no history has: its program ended before the run did. Unset if another program still writes
/// it, or it cannot be read.
std::optional<RunEntry> entryOfRunFile(const QString& path);

struct DroppedRuns {
    int count = 0;
    qint64 bytes = 0;
};

/// Removes the oldest run files of a folder until the others take no more than `bytes`; those in use stay.
DroppedRuns dropOldestRuns(const QString& folder, qint64 bytes, const QStringList& inUse);

/// Removes folders of temporary runs whose program ended without doing so: killed, or with its machine.
DroppedRuns dropDeadScratch(const QString& temporaryFolder);

/// A folder with run files of one case.
struct RunFolder {
    QString path;
    QString casePath;  ///< the case, or the FE result where there is none; empty: not known
    friend bool operator==(const RunFolder&, const RunFolder&) = default;
};

/// Remembers for this user where runs are kept; folders beside cases are found by nothing else.
void noteRunFolder(const RunFolder& folder);
std::vector<RunFolder> notedRunFolders();

/// A run file that is kept, of whatever case.
struct KeptRunFile {
    QString path;
    QString casePath;  ///< empty: not known
    qint64 bytes = 0;
    QDateTime when;                 ///< its run ended; where nobody knows, it was last written
    std::optional<RunEntry> entry;  ///< unset: nothing can be shown of it, or another program writes it
    bool busy = false;              ///< another program writes it
};
/// By folder, the newest first. Each file is looked up in the histories beside its folder and beside its case, else read itself.
std::vector<KeptRunFile> keptRunsIn(const std::vector<RunFolder>& folders);

/// A run file that somebody has chosen, with what it is shown in: the case beside whose folder of runs it lies, the case
/// that is open if the run is of its FE result, else the FE result that it was made from. Throws what io::openRun() throws, and
/// WorldError if that result is not where it was.
KeptRunFile runFileAt(const QString& path, const QString& openCase, const FeResult* open);

/// Takes a run out of all lists so that it can come back; false if another program writes it or the folder cannot be changed.
bool setRunAside(const QString& path);
bool bringRunBack(const QString& path);
/// Removes for good a run that was set aside.
void dropRunSetAside(const QString& path);
/// Brings back what a program had set aside that ended before it could remove it.
void bringStrayRunsBack(const QString& folder);

/// The name of the lock in a folder of temporary runs.
inline const QString scratchLock = QStringLiteral("owner.lock");

}  // namespace rubble
