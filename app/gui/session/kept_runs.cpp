#include "app/gui/session/kept_runs.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <algorithm>

#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/run/run_file.h"

namespace rubble {

namespace {

const QString runEnding = QStringLiteral(".run.h5");
/// s. Temporary folders of versions without locks are left alone for as long.
constexpr qint64 longDead = 86'400;

QFileInfoList runsIn(const QString& folder) {
    return QDir(folder).entryInfoList({u'*' + runEnding}, QDir::Files, QDir::Time | QDir::Reversed);
}

/// Holds nothing but temporary runs, the last of them written long ago.
bool isLongDead(const QDir& folder) {
    const QFileInfoList files = folder.entryInfoList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    return !files.isEmpty() && std::all_of(files.begin(), files.end(), [](const QFileInfo& file) {
        return file.isFile() && file.fileName().startsWith(QLatin1String("run-")) && file.fileName().contains(runEnding) &&
               file.lastModified().secsTo(QDateTime::currentDateTime()) > longDead;
    });
}

}  // namespace

QString newRunFile(const QString& folder) {
    const QString when = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    return folder + u'/' + when + runEnding;
}

std::unique_ptr<QLockFile> holdFile(const QString& path) {
    auto lock = std::make_unique<QLockFile>(path);
    lock->setStaleLockTime(0);
    return lock->tryLock(0) ? std::move(lock) : nullptr;
}

std::optional<RunEntry> entryOfRunFile(const QString& path) {
    if (holdFile(path + QStringLiteral(".lock")) == nullptr) {
        return std::nullopt;
    }
    try {
        const auto run = io::openRun(path.toStdString());
        if (run->frameCount() == 0) {
            return std::nullopt;
        }
        const QFileInfo file(path);
        const io::RunOrigin& origin = run->origin();
        RunEntry entry;
        entry.when = file.lastModified().toUTC().toString(QStringLiteral("yyyy-MM-ddTHH:mm:ssZ")).toStdString();
        entry.scenarioName = origin.scenarioName;
        entry.fingerprint = origin.fingerprint;
        entry.feSha256 = origin.feSha256;
        entry.build = origin.build;
        entry.wallSeconds =
            file.birthTime().isValid() ? static_cast<double>(file.birthTime().msecsTo(file.lastModified())) * 1e-3 : 0.0;
        entry.fragments = run->fragments() != nullptr ? static_cast<std::int64_t>(run->fragments()->size()) : 0;
        entry.bodies = io::standingOf(*run).bodies;
        entry.endTime = run->frameTime(run->frameCount() - 1);
        const io::Taint taint = io::taintOf(*run);
        entry.breaches = static_cast<std::int64_t>(taint.limits);
        entry.grade = taint.grade;
        entry.acknowledged = taint.acknowledgement.has_value();
        entry.interrupted = true;
        if (const auto result = run->result()) {
            entry.complete = true;
            entry.interrupted = false;
            entry.bodies = result->bodiesPeak;
            entry.endTime = result->endTime;
            entry.trajectoryHash = result->trajectoryHash;
        }
        entry.file = path.toStdString();
        return entry;
    } catch (const std::exception&) {
        // Nothing can be shown of it; it goes with the oldest.
        return std::nullopt;
    }
}

DroppedRuns dropOldestRuns(const QString& folder, qint64 bytes, const QStringList& inUse) {
    const QFileInfoList files = runsIn(folder);
    qint64 all = 0;
    for (const QFileInfo& file : files) {
        all += file.size();
    }
    DroppedRuns dropped;
    for (const QFileInfo& file : files) {
        const QString path = file.absoluteFilePath();
        if (all <= bytes) {
            break;
        }
        if (!inUse.contains(path) && holdFile(path + QStringLiteral(".lock")) != nullptr && QFile::remove(path)) {
            QFile::remove(QString::fromStdString(io::acknowledgementPath(path.toStdString())));
            all -= file.size();
            ++dropped.count;
            dropped.bytes += file.size();
        }
    }
    return dropped;
}

DroppedRuns dropDeadScratch(const QString& temporaryFolder) {
    DroppedRuns dropped;
    for (const QString& name : QDir(temporaryFolder).entryList({QStringLiteral("rubble-??????")}, QDir::Dirs)) {
        QDir folder(temporaryFolder + u'/' + name);
        const bool marked = folder.exists(scratchLock);
        // A lock whose program is dead can be taken.
        const bool dead = marked ? holdFile(folder.filePath(scratchLock)) != nullptr : isLongDead(folder);
        if (!dead) {
            continue;
        }
        for (const QFileInfo& file : runsIn(folder.path())) {
            dropped.bytes += file.size();
        }
        dropped.count += folder.removeRecursively() ? 1 : 0;
    }
    return dropped;
}

}  // namespace rubble
