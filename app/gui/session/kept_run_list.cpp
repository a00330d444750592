// Kept runs over all cases: where they lie, what they are, and how one is removed.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QSettings>
#include <algorithm>

#include "app/gui/session/kept_runs.h"
#include "core/base/error.h"
#include "core/fe/fe_result.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_file.h"
#include "io/run/run_history.h"

namespace rubble {

namespace {

const QString foldersKey = QStringLiteral("run_folders");
const QString asideEnding = QStringLiteral(".removed");

bool holdsRuns(const RunFolder& folder) {
    return !QDir(folder.path).entryList({QStringLiteral("*.run.h5")}, QDir::Files).isEmpty();
}

/// What is known without opening a run: from the histories that lie where one of this folder may.
std::vector<RunEntry> historyOf(const RunFolder& folder) {
    std::vector<RunEntry> known;
    for (const QString& file : {QString(folder.path + QStringLiteral(".json")), QString(folder.path + QStringLiteral(".runs.json")),
                                QString::fromStdString(io::runHistoryPath(folder.casePath.toStdString()))}) {
        try {
            const std::vector<RunEntry> read = io::readRunHistory(file.toStdString());
            known.insert(known.end(), read.begin(), read.end());
        } catch (const std::exception&) {
            // Its case says what is wrong with it; the runs are read themselves.
        }
    }
    return known;
}

/// The FE result that a run was made from; empty if it cannot be read.
QString resultOf(const QString& run) {
    try {
        return QString::fromStdString(io::openRun(run.toStdString())->origin().fePath);
    } catch (const std::exception&) {
        return {};
    }
}

KeptRunFile keptRun(const QFileInfo& file, const RunFolder& folder, const std::vector<RunEntry>& known) {
    KeptRunFile run{file.absoluteFilePath(), folder.casePath, file.size(), file.lastModified(), std::nullopt, false};
    const auto listed = std::find_if(known.begin(), known.end(), [&](const RunEntry& each) {
        return QFileInfo(QString::fromStdString(each.file)).fileName() == file.fileName();
    });
    run.busy = holdFile(run.path + QStringLiteral(".lock")) == nullptr;
    if (!run.busy) {
        run.entry = listed != known.end() && !listed->hasOnlyBegun() ? std::optional(*listed) : entryOfRunFile(run.path);
        if (run.entry) {
            run.entry->file = run.path.toStdString();
            io::takeVerdict(*run.entry);
            // A file may be written to after its run ended, by who vouches for it.
            if (const auto ended = QDateTime::fromString(QString::fromStdString(run.entry->when), Qt::ISODate); ended.isValid()) {
                run.when = ended;
            }
        }
        if (run.casePath.isEmpty()) {
            run.casePath = resultOf(run.path);
        }
    }
    return run;
}

}  // namespace

std::vector<RunFolder> notedRunFolders() {
    std::vector<RunFolder> folders;
    QSettings settings;
    const int count = settings.beginReadArray(foldersKey);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        folders.push_back({settings.value(QStringLiteral("folder")).toString(), settings.value(QStringLiteral("case")).toString()});
    }
    settings.endArray();
    return folders;
}

void noteRunFolder(const RunFolder& folder) {
    std::vector<RunFolder> folders = notedRunFolders();
    if (std::find(folders.begin(), folders.end(), folder) != folders.end()) {
        return;
    }
    // Those without runs are of cases that went, or whose runs went.
    std::erase_if(folders, [&](const RunFolder& each) { return each.path == folder.path || !holdsRuns(each); });
    folders.push_back(folder);
    QSettings settings;
    settings.remove(foldersKey);
    settings.beginWriteArray(foldersKey, static_cast<int>(folders.size()));
    for (int i = 0; i < static_cast<int>(folders.size()); ++i) {
        settings.setArrayIndex(i);
        settings.setValue(QStringLiteral("folder"), folders[static_cast<std::size_t>(i)].path);
        settings.setValue(QStringLiteral("case"), folders[static_cast<std::size_t>(i)].casePath);
    }
    settings.endArray();
}

std::vector<KeptRunFile> keptRunsIn(const std::vector<RunFolder>& folders) {
    std::vector<KeptRunFile> runs;
    QStringList seen;
    for (const RunFolder& folder : folders) {
        const QString place = QFileInfo(folder.path).canonicalFilePath();
        if (place.isEmpty() || seen.contains(place)) {
            continue;
        }
        seen << place;
        const QFileInfoList files = QDir(folder.path).entryInfoList({QStringLiteral("*.run.h5")}, QDir::Files, QDir::Time);
        const std::vector<RunEntry> known = files.isEmpty() ? std::vector<RunEntry>() : historyOf(folder);
        for (const QFileInfo& file : files) {
            runs.push_back(keptRun(file, folder, known));
        }
    }
    return runs;
}

KeptRunFile runFileAt(const QString& path, const QString& openCase, const FeResult* open) {
    const QFileInfo file(path);
    const io::RunOrigin origin = io::openRun(path.toStdString())->origin();
    KeptRunFile run{file.absoluteFilePath(), openCase, file.size(), file.lastModified(), entryOfRunFile(path), false};
    const QString ending = QStringLiteral(".runs");
    const QString folder = file.absolutePath();
    const QString result = QString::fromStdString(origin.fePath);
    const QString beside = folder + u'/' + QFileInfo(result).fileName();
    const bool ofOpen = !openCase.isEmpty() && open != nullptr && open->contents().sha256 == origin.feSha256;
    if (folder.endsWith(ending) && QFile::exists(folder.chopped(ending.size()))) {
        run.casePath = folder.chopped(ending.size());
    } else if (ofOpen) {
        return run;
    } else if (origin.scenario.import != ImportSettings()) {
        // By itself the result would be read in other units or axes than the run was made in.
        throw UsageError({"gui.run_without_case",
                          "The run {0} was made in a case that says how {1} is read",
                          {path.toStdString(), origin.fePath}},
                         {"gui.run_without_case.remedy", "Open that case, then choose the run again.", {}});
    } else if (QFile::exists(result)) {
        run.casePath = result;
    } else if (QFile::exists(beside)) {
        run.casePath = beside;
    } else {
        throw WorldError(
            {"gui.run_alone", "The run {0} was made from {1}, which is not there", {path.toStdString(), origin.fePath}},
            {"gui.run_alone.remedy", "Put that file there or beside the run, or open the case and choose the run again.", {}});
    }
    return run;
}

bool setRunAside(const QString& path) {
    const auto lock = holdFile(path + QStringLiteral(".lock"));
    return lock != nullptr && QFile::rename(path, path + asideEnding);
}

bool bringRunBack(const QString& path) {
    return QFile::rename(path + asideEnding, path);
}

void dropRunSetAside(const QString& path) {
    if (QFile::remove(path + asideEnding)) {
        QFile::remove(QString::fromStdString(io::acknowledgementPath(path.toStdString())));
    }
}

void bringStrayRunsBack(const QString& folder) {
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.run.h5") + asideEnding}, QDir::Files)) {
        bringRunBack(file.absoluteFilePath().chopped(asideEnding.size()));
    }
}

}  // namespace rubble
