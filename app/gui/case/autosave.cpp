#include "app/gui/case/autosave.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <algorithm>

#include "app/gui/session/document.h"
#include "app/gui/session/worker.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/case/autosave_file.h"

namespace rubble {

namespace {

const QString ending = QStringLiteral(".unsaved.json");
const QString lockEnding = QStringLiteral(".lock");

std::unique_ptr<QLockFile> lockOf(const QString& file) {
    auto lock = std::make_unique<QLockFile>(file + lockEnding);
    // However long a program has been open, its work is its own as long as it lives.
    lock->setStaleLockTime(0);
    return lock;
}

}  // namespace

QString setFileAside(const QString& path) {
    const QString when = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    for (int n = 0; n < 100; ++n) {
        const QString target = path + QStringLiteral(".damaged-") + when + (n > 0 ? QStringLiteral("-%1").arg(n) : QString());
        if (!QFile::exists(target)) {
            return QFile::rename(path, target) ? target : QString();
        }
    }
    return {};
}

int Autosave::chosenInterval() {
    bool ok = false;
    const int seconds = QSettings().value(QStringLiteral("autosave_seconds"), defaultInterval).toInt(&ok);
    return ok ? std::clamp(seconds, 0, 3600) : defaultInterval;
}

Autosave::Autosave(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(folder) {
    m_timer.setSingleShot(true);
    setInterval(chosenInterval());
    connect(&m_timer, &QTimer::timeout, this, &Autosave::saveNow);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &Autosave::changed);
    connect(&document.undoStack(), &QUndoStack::cleanChanged, this, &Autosave::changed);
    connect(&document, &Document::replaced, this, [this] {
        clear();
        // A case that the wizard made is in no file at all.
        if (m_timer.interval() > 0) {
            saveNow();
        }
    });
    connect(&document, &Document::titleChanged, this, &Autosave::changed);
}

Autosave::~Autosave() {
    clear();
}

void Autosave::setInterval(int seconds) {
    m_timer.setInterval(seconds * 1000);
    if (seconds == 0) {
        m_timer.stop();
    }
}

void Autosave::changed() {
    if (!m_document.modified()) {
        clear();
    } else if (!m_timer.isActive() && m_timer.interval() > 0 && !m_folder.isEmpty()) {
        // Counted from the first change, so that a user who never pauses is saved too.
        m_timer.start();
    }
}

void Autosave::clear() {
    m_timer.stop();
    if (!m_file.isEmpty()) {
        QFile::remove(m_file);
        m_file.clear();
    }
    m_lock.reset();
}

bool Autosave::claimFile() {
    if (!m_file.isEmpty()) {
        return true;
    }
    QDir().mkpath(m_folder);
    const QByteArray key = QCryptographicHash::hash(m_document.base().toUtf8(), QCryptographicHash::Sha256).toHex().left(16);
    for (int n = 0; n < 1000; ++n) {
        const QString file = QStringLiteral("%1/%2-%3%4").arg(m_folder, QString::fromLatin1(key)).arg(n).arg(ending);
        auto lock = lockOf(file);
        // A file that is there belongs to somebody, or is waiting to be recovered.
        if (!QFile::exists(file) && lock->tryLock(0)) {
            m_lock = std::move(lock);
            m_file = file;
            return true;
        }
    }
    return false;
}

void Autosave::saveNow() {
    if (!m_document.modified() || m_folder.isEmpty()) {
        return;
    }
    if (!claimFile()) {
        if (!std::exchange(m_told, true)) {
            emit failed({[folder = m_folder] { return tr("Changes cannot be autosaved in %1").arg(folder); },
                         [] { return tr("Make room there or allow writing, or save the case yourself."); }, "gui.autosave"});
        }
        return;
    }
    try {
        io::writeAutosave(m_file.toStdString(),
                          {m_document.path().toStdString(), m_document.base().toStdString(), utcNow(), m_document.theCase()});
        m_told = false;
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        // Told once, not every minute; tried again with the next change.
        if (failure && !std::exchange(m_told, true)) {
            emit failed({[what = failure->what] { return tr("Changes cannot be autosaved. %1").arg(what()); }, failure->remedy,
                         "gui.autosave"});
        }
    }
}

std::vector<LeftWork> Autosave::leftWork() {
    std::vector<LeftWork> found;
    if (m_folder.isEmpty()) {
        return found;
    }
    for (const QString& name : QDir(m_folder).entryList({u'*' + ending}, QDir::Files, QDir::Name)) {
        const QString file = m_folder + u'/' + name;
        std::shared_ptr<QLockFile> lock = lockOf(file);
        if (!lock->tryLock(0) || !QFile::exists(file)) {
            continue;
        }
        try {
            io::AutosavedCase kept = io::readAutosave(file.toStdString());
            found.push_back({file, std::move(kept.theCase), QString::fromStdString(kept.path), QString::fromStdString(kept.base),
                             QDateTime::fromString(QString::fromStdString(kept.savedAt), Qt::ISODate), std::move(lock)});
        } catch (...) {
            const auto failure = failureOf(std::current_exception());
            emit setAside(*failure, setFileAside(file));
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const LeftWork& a, const LeftWork& b) { return a.savedAt > b.savedAt; });
    return found;
}

void Autosave::remove(const LeftWork& work) {
    QFile::remove(work.file);
}

}  // namespace rubble
