#include "app/gui/window/first_visit.h"

#include <QSettings>

#include "app/gui/case/project_files.h"
#include "app/gui/case/start_display.h"
#include "app/gui/session/sample.h"
#include "app/gui/session/session.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/options.h"
#include "widgets/views/tour.h"

namespace rubble {

namespace {

const QString seenKey = QStringLiteral("tour_seen");

}  // namespace

FirstVisit::FirstVisit(MainWindow& window, widgets::Tour& tour) : QObject(&window), m_window(window), m_tour(tour) {
    connect(&tour, &widgets::Tour::ended, this, [] { QSettings().setValue(seenKey, true); });
    connect(window.rooms().opening.get(), &Opening::changed, this, &FirstVisit::look);
    const auto giveUp = [this] { m_awaited.clear(); };
    connect(&window.session(), &Session::failed, this, giveUp);
    connect(&window.session().computation(), &Computation::failed, this, giveUp);
}

bool FirstVisit::isDue(Session& session, const Options& options) {
    const ProjectFiles& files = session.part<ProjectFiles>();
    return options.asksForNothing() && !QSettings().value(seenKey, false).toBool() && files.recent.list().empty() &&
           files.left.empty();
}

void FirstVisit::begin() {
    const QString sample = samplePath();
    if (!m_window.session().document().empty() || m_window.session().computation().busy() || sample.isEmpty()) {
        m_tour.start();
        return;
    }
    m_awaited = sample;
    // Nobody has chosen it.
    m_window.rooms().project->start().passOver(sample);
    m_window.open(sample, true);
}

void FirstVisit::look() {
    const Document& document = m_window.session().document();
    if (m_awaited.isEmpty() || document.empty()) {
        return;
    }
    const bool there = document.path() == m_awaited && m_window.session().computation().inputs().fe != nullptr;
    m_awaited.clear();
    if (there) {
        m_tour.start();
    }
}

}  // namespace rubble
