#include "app/gui/case/recovery.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include "app/gui/session/kept_runs.h"
#include "app/gui/session/session.h"
#include "widgets/basics/notice_bar.h"

namespace rubble {

Recovery::Recovery(Session& session, QBoxLayout& notices, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_files(session.part<ProjectFiles>()),
      m_bar(new widgets::NoticeBar) {
    notices.addWidget(m_bar);
    m_bar->hide();
    connect(m_bar, &widgets::NoticeBar::chosen, this, &Recovery::choose);
    connect(&m_document, &Document::replaced, this, [this] {
        // Only what lies safe in a file of this program's own may go.
        if (m_files.asked && m_document.modified() && m_document.base() == m_files.asked->base) {
            m_files.autosave.saveNow();
            if (!m_files.autosave.file().isEmpty()) {
                Autosave::remove(*m_files.asked);
                m_files.left.pop_front();
            }
            m_files.asked.reset();
            offer();
        }
    });
    offer();
}

void Recovery::look() {
    if (const DroppedRuns dropped = dropDeadScratch(QDir::tempPath()); dropped.count > 0) {
        m_session.tell(tr("Temporary runs of a program that ended early were removed: %1 GiB")
                           .arg(QLocale().toString(static_cast<double>(dropped.bytes) / (1 << 30), 'f', 2)));
    }
    m_files.left.clear();
    for (LeftWork& work : m_files.autosave.leftWork()) {
        m_files.left.push_back(std::move(work));
    }
    offer();
}

QString Recovery::text() const {
    return m_files.left.empty() ? QString() : m_bar->text();
}

void Recovery::offer() {
    m_bar->setVisible(!m_files.left.empty());
    if (m_files.left.empty()) {
        return;
    }
    const LeftWork& work = m_files.left.front();
    const QString name = QString::fromStdString(work.theCase.title);
    const QString when = QLocale().toString(work.savedAt.toLocalTime(), QLocale::ShortFormat);
    QString more =
        work.path.isEmpty() ? tr("The case was never saved.") : tr("They are not in %1.").arg(QFileInfo(work.path).fileName());
    if (m_files.left.size() > 1) {
        more += u' ' + tr("Others follow: %1.").arg(m_files.left.size() - 1);
    }
    m_bar->setContent(
        tr("Rubble ended before changes of “%1” were saved. They were kept at %2.").arg(name, when), more,
        {{QStringLiteral("recover"), tr("Recover"), tr("Open the case with these changes; they can be saved then"), true},
         {QStringLiteral("discard"), tr("Discard"), tr("Remove these changes for good"), false},
         {QStringLiteral("later"), tr("Later"), tr("Ask again at the next start"), false}});
}

void Recovery::choose(const QString& id) {
    if (m_files.left.empty()) {
        return;
    }
    if (id == QLatin1String("recover")) {
        m_files.asked = m_files.left.front();
        emit recoverRequested(*m_files.asked);
        return;
    }
    if (id == QLatin1String("discard")) {
        Autosave::remove(m_files.left.front());
        m_session.tell(tr("Changes of “%1” were discarded").arg(QString::fromStdString(m_files.left.front().theCase.title)));
    }
    m_files.left.pop_front();
    offer();
}

}  // namespace rubble
