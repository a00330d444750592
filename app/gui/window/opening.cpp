#include "app/gui/window/opening.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QThread>
#include <algorithm>
#include <utility>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/case/project_files.h"
#include "app/gui/exports/figure_return.h"
#include "app/gui/run/health_display.h"
#include "app/gui/session/sample.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/scene_display.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/selection_display.h"
#include "io/fe/fe_reader.h"
#include "widgets/basics/unit_label.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/case/start_page.h"
#include "widgets/figures/export_record.h"
#include "widgets/figures/number_text.h"

namespace rubble {

namespace {

/// Whether what is seen of one result can be seen of another alike: the files around it may be others.
bool sameToSee(const std::shared_ptr<const FeResult>& a, const std::shared_ptr<const FeResult>& b) {
    return a != nullptr && b != nullptr && a->times() == b->times() && a->mesh().nodes == b->mesh().nodes;
}

}  // namespace

Opening::Opening(Session& session, const Shown& shown, Actions& actions, QWidget& window)
    : m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_shown(shown),
      m_window(window),
      m_return(session.part<FigureReturn>()),
      m_kept(session.part<Kept>()) {
    connectActions(actions);
    connectSession();
}

Opening::~Opening() {
    m_computation.welcomeBy({});
    delete m_newCase;
}

void Opening::connectActions(Actions& actions) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::Open, [this] {
        if (const QString path = m_shown.files.askForInput(); !path.isEmpty()) {
            open(path);
        }
    });
    on(ActionId::NewCase, [this] { newCase(); });
    on(ActionId::Sample, [this] { openSample(); });
    on(ActionId::Refresh, [this] { refreshResult(); });
    on(ActionId::Close, [this] {
        if (m_shown.files.mayLeave()) {
            closeCase();
        }
    });
    widgets::StartPage& page = m_shown.area.startPage();
    connect(&page, &widgets::StartPage::openRequested, &actions[ActionId::Open], &QAction::trigger);
    connect(&page, &widgets::StartPage::newRequested, &actions[ActionId::NewCase], &QAction::trigger);
}

void Opening::connectSession() {
    m_computation.welcomeBy([this](const Opened& opened) { return welcomeFor(opened); });
    connect(&m_computation, &Computation::opened, this, &Opening::takeOpened);
    connect(&m_computation, &Computation::prepared, this, &Opening::prepared);
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this] { m_kept.askedToLeave = false; });
    connect(&m_document, &Document::scenarioChanged, this, &Opening::scenarioChanged);
    connect(&m_document, &Document::inputsChanged, this, &Opening::reopen);
    connect(&m_shown.deck, &PanelDeck::gridSettled, this, &Opening::scenarioChanged);
    connect(&m_return, &FigureReturn::openRequested, this, [this](const QString& path) {
        if (!load(path, false)) {
            m_return.forget();
        }
    });
    connect(&m_return, &FigureReturn::viewRequested, this, [this](const render::View& view, double aspect) {
        m_shown.scene.look(figures::reshaped(view, aspect, m_shown.area.views().width(), m_shown.area.views().height()));
    });
}

void Opening::open(const QString& path, bool simulate) {
    if (FigureReturn::carriesSource(path)) {
        m_return.begin(path);
        return;
    }
    if (path.endsWith(QLatin1String(".rubblecase"), Qt::CaseInsensitive)) {
        emit sealedChosen(path);
        return;
    }
    if (path.endsWith(QLatin1String(".run.h5"), Qt::CaseInsensitive)) {
        emit runChosen(path);
        return;
    }
    m_return.forget();
    load(path, simulate);
}

bool Opening::load(const QString& path, bool simulate) {
    if (!m_shown.files.mayLeave()) {
        return false;
    }
    m_kept.askedToLeave = true;
    m_kept.simulateWhenReady = simulate;
    forgetFailures();
    m_computation.open(path);
    return true;
}

void Opening::forgetFailures() {
    m_shown.area.setError({});
    m_shown.deck.clearFailures();
}

void Opening::openSample() {
    const QString path = samplePath();
    if (path.isEmpty()) {
        m_session.report({[] { return tr("The sample is not installed."); },
                          [] { return tr("Install Rubble's samples folder, or open a result of your own."); }, "gui.sample"});
    } else {
        open(path, true);
    }
}

void Opening::recover(const LeftWork& work) {
    if (m_shown.files.mayLeave()) {
        m_kept.askedToLeave = true;
        m_kept.simulateWhenReady = false;
        forgetFailures();
        m_computation.reopen(work.theCase, work.path, work.base, true);
    }
}

void Opening::reopen() {
    m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base());
}

void Opening::stayStill() {
    m_kept.simulateWhenReady = false;
}

void Opening::refreshResult() {
    const auto fe = m_computation.inputs().fe;
    if (fe == nullptr) {
        return;
    }
    const auto grown = std::make_shared<bool>(false);
    m_computation.write([fe, grown](const Execution&) { *grown = io::hasGrown(*fe); },
                        [session = &m_session, kept = &m_kept, fe, grown](const std::exception_ptr& thrown) {
                            if (const auto failure = failureOf(thrown)) {
                                session->report(*failure);
                            } else if (!*grown) {
                                session->tell(tr("Nothing new: the result has %1 states").arg(fe->stateCount()));
                            } else if (session->computation().inputs().fe == fe) {
                                kept->refreshed = fe;
                                const Document& document = session->document();
                                session->computation().reopen(document.theCase(), document.path(), document.base());
                            }
                        });
}

void Opening::showRefreshed(const FeResult& before, const render::View& view, double time) {
    const FeResult& fe = *m_computation.inputs().fe;
    const io::FeGrowth growth = io::growthBetween(before, fe);
    m_shown.scene.setView(view);
    m_shown.playback.scrub(std::clamp(time, fe.times().front(), fe.times().back()));
    m_session.tell(growth.states > 0 ? tr("%1 states more, to %2; %3 elements more are dead")
                                           .arg(growth.states)
                                           .arg(figures::timeText(fe.times().back()))
                                           .arg(growth.deaths)
                                     : tr("The result was read again: %1 states").arg(fe.stateCount()));
}

void Opening::closeCase() {
    m_shown.inspection.selection().clear();
    m_computation.clear();
    m_document.close();
    m_shown.scene.show();
    m_shown.area.showViews(false);
    m_shown.area.setError({});
    m_shown.playback.reset();
    m_shown.health.refresh();
    m_shown.deck.showOutcome({});
    m_shown.deck.clearFailures();
    m_shown.deck.choose(PanelDeck::Case);
}

Welcome Opening::welcomeFor(const Opened& opened) {
    // What a dialog or a menu asks for is meant for the case that was there when it came up.
    if (QApplication::activeModalWidget() != nullptr || QThread::currentThread()->loopLevel() > 1) {
        return Welcome::Later;
    }
    const bool same = !m_document.empty() && opened.base == m_document.base();
    // The case may have been edited since somebody agreed to leave it.
    if (same || m_kept.askedToLeave || !opened.recognised()) {
        return Welcome::Now;
    }
    m_kept.askedToLeave = m_shown.files.mayLeave();
    if (m_kept.askedToLeave) {
        return Welcome::Now;
    }
    m_kept.simulateWhenReady = false;
    m_return.forget();
    emit changed();
    return Welcome::Never;
}

void Opening::takeOpened(const Opened& opened) {
    const auto before = std::exchange(m_kept.refreshed, nullptr);
    const bool again =
        !opened.recovered && !m_document.empty() && opened.base == m_document.base() && m_document.standsOn(opened.theCase);
    const bool terrainFailed = opened.failure && opened.failure->id.starts_with("terrain.");
    if (!opened.recognised() || (again && opened.fe == nullptr && m_computation.inputs().fe != nullptr && !terrainFailed)) {
        // Not a result at all, or not with these settings: what was open stays.
        m_session.report(*opened.failure);
        emit changed();
        return;
    }
    if (!again) {
        m_document.replace(opened.theCase, opened.path, opened.base, opened.recovered);
        m_kept.askedToLeave = false;
    }
    const bool refreshed = again && before != nullptr && before == m_computation.inputs().fe && opened.fe != nullptr;
    const bool around = again && !refreshed && !m_kept.simulateWhenReady && sameToSee(m_computation.inputs().fe, opened.fe);
    const render::View viewBefore = m_shown.area.views().view();
    const widgets::ViewWidget::Moved moved = m_shown.area.views().moved();
    const double timeBefore = m_shown.playback.clock().time();
    m_computation.take(opened, m_document.scenario());
    tellTimes();
    m_shown.scene.show();
    if (opened.fe != nullptr && !refreshed && !around) {
        m_shown.scene.lookAtAll();
    }
    m_shown.area.showViews(opened.fe != nullptr, true);
    m_shown.health.refresh();
    if (m_computation.currentRun() == nullptr) {
        m_shown.deck.showOutcome({});
    }
    m_shown.playback.reset();
    if (opened.fe != nullptr && m_kept.simulateWhenReady) {
        m_shown.playback.clock().play();
    }
    if (refreshed) {
        showRefreshed(*before, viewBefore, timeBefore);
    } else if (around) {
        m_shown.scene.setView(viewBefore);
        m_shown.playback.scrub(timeBefore);
    }
    if (refreshed || around) {
        m_shown.area.views().setMoved(moved);
    } else {
        m_shown.deck.choose(opened.fe != nullptr && !opened.path.isEmpty() ? PanelDeck::Grid : PanelDeck::Case);
    }
    emit changed();
}

// Of the result that is open; a wizard tells those of another one meanwhile.
void Opening::tellTimes() {
    const auto& fe = m_computation.inputs().fe;
    if (!widgets::showTimesFor(fe != nullptr && fe->stateCount() > 0 ? fe->times().back() - fe->times().front() : 0.0)) {
        // Fields keep what is half typed while a result grows.
        m_shown.deck.run().showBriefResult();
    }
}

void Opening::scenarioChanged() {
    m_shown.deck.showScenario();
    if (m_shown.deck.grid().dragging()) {
        // Clusters are counted meanwhile; the rest follows when the slider rests.
        return;
    }
    const bool reread = m_computation.inputs().fe == nullptr || m_computation.importStale(m_document.scenario());
    if (reread && !m_document.empty()) {
        reopen();
    } else {
        m_computation.update(m_document.scenario());
    }
    m_shown.playback.refresh(m_computation.runStale(m_document.scenario()));
    m_shown.scene.show();
    emit changed();
}

void Opening::prepared() {
    m_shown.deck.showResults();
    forgetFailures();
    if (m_computation.failure()) {
        m_session.report(*m_computation.failure());
    }
    m_shown.scene.show();
    emit changed();
    const bool ready =
        m_computation.results().clustering != nullptr && !m_computation.stale(Stage::Clusters, m_document.scenario());
    if (m_kept.simulateWhenReady && ready) {
        m_kept.simulateWhenReady = false;
        emit simulateRequested();
    }
}

NewCase* Opening::caseInTheMaking() const {
    return m_newCase;
}

void Opening::newCase(const QString& path) {
    if (m_newCase != nullptr) {
        m_newCase->wizard().raise();
        m_newCase->wizard().activateWindow();
        return;
    }
    const QString file = path.isEmpty()
                             ? QFileDialog::getOpenFileName(&m_window, tr("FE result of the new case"),
                                                            QFileInfo(m_document.base()).absolutePath(), tr("FE results (*)"))
                             : path;
    if (file.isEmpty()) {
        return;
    }
    const widgets::Preferences& preferences = m_session.preferences();
    m_newCase = new NewCase(file, static_cast<std::size_t>(preferences.memoryMib) << 20, preferences.keepCopies, m_window);
    connect(m_newCase, &NewCase::finished, m_newCase, &QObject::deleteLater);
    connect(m_newCase, &NewCase::finished, this, &Opening::tellTimes);
    connect(m_newCase, &NewCase::created, this, &Opening::takeMade);
}

void Opening::takeMade(const Opened& opened, const render::View& looks) {
    if (!m_shown.files.mayLeave()) {
        return;
    }
    m_kept.simulateWhenReady = false;
    m_newCase->wizard().accept();
    takeOpened(opened);
    render::View view = m_shown.area.views().view();
    view.componentColours = looks.componentColours;
    view.hiddenComponents = looks.hiddenComponents;
    m_shown.scene.setView(view);
    m_shown.inspection.refresh();
    m_shown.deck.choose(PanelDeck::Grid);
}

}  // namespace rubble
