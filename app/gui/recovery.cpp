#include "app/gui/recovery.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QLocale>

#include "app/gui/document.h"
#include "widgets/notice_bar.h"

namespace rubble {

Recovery::Recovery(Document& document, Autosave& autosave, QBoxLayout& notices, QObject* parent)
    : QObject(parent), m_document(document), m_autosave(autosave), m_bar(new widgets::NoticeBar) {
    notices.addWidget(m_bar);
    m_bar->hide();
    connect(m_bar, &widgets::NoticeBar::chosen, this, &Recovery::choose);
    connect(&document, &Document::replaced, this, [this] {
        // Only what lies safe in a file of this program's own may go.
        if (m_asked && m_document.modified() && m_document.base() == m_asked->base) {
            m_autosave.saveNow();
            if (!m_autosave.file().isEmpty()) {
                Autosave::remove(*m_asked);
                m_left.pop_front();
            }
            m_asked.reset();
            offer();
        }
    });
}

void Recovery::look() {
    m_left.clear();
    for (LeftWork& work : m_autosave.leftWork()) {
        m_left.push_back(std::move(work));
    }
    offer();
}

QString Recovery::text() const {
    return m_left.empty() ? QString() : m_bar->text();
}

void Recovery::offer() {
    m_bar->setVisible(!m_left.empty());
    if (m_left.empty()) {
        return;
    }
    const LeftWork& work = m_left.front();
    const QString name = QString::fromStdString(work.theCase.title);
    const QString when = QLocale().toString(work.savedAt.toLocalTime(), QLocale::ShortFormat);
    QString more =
        work.path.isEmpty() ? tr("The case was never saved.") : tr("They are not in %1.").arg(QFileInfo(work.path).fileName());
    if (m_left.size() > 1) {
        more += u' ' + tr("Others follow: %1.").arg(m_left.size() - 1);
    }
    m_bar->setContent(
        tr("Rubble ended before changes of “%1” were saved. They were kept at %2.").arg(name, when), more,
        {{QStringLiteral("recover"), tr("Recover"), tr("Open the case with these changes; they can be saved then"), true},
         {QStringLiteral("discard"), tr("Discard"), tr("Remove these changes for good"), false},
         {QStringLiteral("later"), tr("Later"), tr("Ask again at the next start"), false}});
}

void Recovery::choose(const QString& id) {
    if (m_left.empty()) {
        return;
    }
    if (id == QLatin1String("recover")) {
        m_asked = m_left.front();
        emit recoverRequested(*m_asked);
        return;
    }
    if (id == QLatin1String("discard")) {
        Autosave::remove(m_left.front());
        emit told(tr("Changes of “%1” were discarded").arg(QString::fromStdString(m_left.front().theCase.title)));
    }
    m_left.pop_front();
    offer();
}

}  // namespace rubble
