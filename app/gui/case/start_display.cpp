#include "app/gui/case/start_display.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QTimer>
#include <array>

#include "app/gui/session/sample.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/view_area.h"
#include "widgets/case/start_page.h"
#include "widgets/figures/shown_units.h"

namespace rubble {

namespace {

// The views have drawn by then, and the first seconds belong to the user.
constexpr int pictureDelay = 2500;  // ms

QString shownDate(const QDateTime& when) {
    if (!when.isValid()) {
        return {};
    }
    const QDateTime local = when.toLocalTime();
    return local.date() == QDate::currentDate()
               ? StartDisplay::tr("today, %1").arg(QLocale().toString(local.time(), QLocale::ShortFormat))
               : QLocale().toString(local.date(), QLocale::ShortFormat);
}

}  // namespace

StartDisplay::StartDisplay(Session& session, ViewArea& area, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_area(area),
      m_files(session.part<ProjectFiles>()) {
    widgets::StartPage& page = area.startPage();
    connect(&page, &widgets::StartPage::recentChosen, this, &StartDisplay::openRequested);
    connect(&page, &widgets::StartPage::sampleChosen, this, [this](const QString& path) {
        m_passedOver.clear();
        emit sampleRequested(path);
    });
    connect(&page, &widgets::StartPage::tourRequested, this, &StartDisplay::tourRequested);
    connect(&page, &widgets::StartPage::forgetRequested, this, [this](const QString& path) {
        m_files.recent.forget(path);
        refresh();
    });
    connect(&page, &widgets::StartPage::locateRequested, this, [this](const QString& path) {
        const QString to = QFileDialog::getOpenFileName(&m_area, tr("Locate %1").arg(QFileInfo(path).fileName()),
                                                        QFileInfo(path).absolutePath(), tr("Cases and FE results (*)"));
        if (!to.isEmpty()) {
            locate(path, to);
        }
    });
    if (m_files.remembers) {
        follow();
    }
    refresh();
}

void StartDisplay::locate(const QString& from, const QString& to) {
    m_files.recent.move(from, to);
    refresh();
    emit openRequested(to);
}

namespace {

/// Names and notes of the cases that come with the program; those cases are files and speak English.
[[maybe_unused]] constexpr std::array sampleTexts = {
    QT_TRANSLATE_NOOP("samples", "Stone arch bridge, four spans"),
    QT_TRANSLATE_NOOP("samples",
                      "The strips whose loss of strength starts the collapse belong to their arch rings. All is natural stone of "
                      "2,400 kg/m3, as in the FE result; EN 1991-1-1:2002, table A.2, gives sandstone 21 to 27 kN/m3 (2,140 to "
                      "2,750 kg/m3)."),
    QT_TRANSLATE_NOOP("samples", "Reinforced concrete arch above a river"),
    QT_TRANSLATE_NOOP("samples",
                      "All concrete is reinforced; the river flows north at 1 m/s with its surface half a metre below "
                      "the valley floor.")};

QString saidOfSample(const QString& text) {
    return figures::raisedUnits(QCoreApplication::translate("samples", text.toUtf8().constData()));
}

}  // namespace

void StartDisplay::refresh() {
    std::vector<widgets::StartCase> recent;
    for (const RecentCase& each : m_files.recent.list()) {
        recent.push_back({each.path, each.name, each.path, shownDate(each.when), m_files.recent.picture(each.path), each.missing});
    }
    m_area.startPage().setRecent(recent);
    std::vector<widgets::StartCase> shipped;
    for (const Sample& each : samples()) {
        const QImage own = m_files.recent.picture(each.path);
        shipped.push_back({each.path,
                           saidOfSample(each.name),
                           saidOfSample(each.words),
                           {},
                           !each.picture.isEmpty() ? QImage(each.picture) : own,
                           false});
    }
    m_area.startPage().setSamples(shipped);
}

void StartDisplay::remember() {
    if (!m_files.remembers) {
        m_files.remembers = true;
        follow();
    }
}

void StartDisplay::follow() {
    connect(&m_document, &Document::replaced, this, &StartDisplay::noteOpened);
    connect(&m_document, &Document::titleChanged, this, [this] {
        if (!m_document.empty() && (m_files.recent.list().empty() || m_files.recent.list().front().path != m_document.openPath())) {
            noteOpened();
        }
    });
    connect(&m_computation, &Computation::opened, this,
            [this] { QTimer::singleShot(pictureDelay, this, &StartDisplay::takePicture); });
    connect(&m_computation, &Computation::runEnded, this, &StartDisplay::takePicture);
}

void StartDisplay::noteOpened() {
    if (!m_document.empty() && m_document.openPath() != m_passedOver) {
        m_files.recent.add(m_document.openPath(), QString::fromStdString(m_document.theCase().title));
    }
    refresh();
}

void StartDisplay::takePicture() {
    const bool chosen = !m_document.empty() && m_document.openPath() != m_passedOver;
    if (chosen && m_computation.inputs().fe != nullptr && m_area.views().isVisible()) {
        m_files.recent.setPicture(m_document.openPath(), m_area.views().picture());
    }
}

}  // namespace rubble
