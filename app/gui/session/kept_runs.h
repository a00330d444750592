#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/pipeline/run_entry.h"

class QLockFile;

namespace rubble {

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

/// The name of the lock in a folder of temporary runs.
inline const QString scratchLock = QStringLiteral("owner.lock");

}  // namespace rubble
