#include "app/gui/accuracy/accuracy_display.h"

#include "app/gui/accuracy/comparison_memory.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/studies/answer.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/accuracy/accuracy_words.h"
#include "widgets/basics/place_choice.h"

namespace rubble {

AccuracyDisplay::AccuracyDisplay(Session& session, PanelDeck& deck, widgets::AccuracyPage& page, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_page(page),
      m_work(session.part<AccuracyWork>()),
      m_kept(session.part<Kept>()) {
    connect(&m_work, &AccuracyWork::grew, this, &AccuracyDisplay::refresh);
    connect(&m_work, &AccuracyWork::ended, this, &AccuracyDisplay::ended);
    connect(&m_work, &AccuracyWork::progressed, this, [this](const QString& what, double fraction, double left) {
        m_kept.fraction = fraction;
        m_deck.accuracy().setProgress(what, fraction, left);
        showRail();
    });
    connect(&m_deck.accuracy(), &widgets::AccuracyPanel::compareRequested, this, &AccuracyDisplay::compare);
    connect(&m_deck.accuracy(), &widgets::AccuracyPanel::cancelRequested, this, &AccuracyDisplay::cancel);
    connect(&m_work, &AccuracyWork::begun, this, [this] {
        refresh();
        emit changed();
    });
    connect(&m_work, &AccuracyWork::resumed, this, [this](const widgets::AccuracyPanel::Request& request) {
        m_deck.accuracy().setRequest(request);
        m_session.tell(tr("Settings of this case were compared on the cluster: here they are"));
    });
    widgets::PlaceChoice& place = m_deck.accuracy().place();
    connect(&place, &widgets::PlaceChoice::shown, &m_work.cluster(), &ClusterWork::probe);
    connect(&place, &widgets::PlaceChoice::chosen, this, &AccuracyDisplay::showPanel);
    connect(&m_work.cluster(), &ClusterWork::reached, &place, &widgets::PlaceChoice::setReached);
    connect(&m_page, &widgets::AccuracyPage::rowChosen, this, &AccuracyDisplay::adopt);
    connect(&m_computation, &Computation::prepared, this, &AccuracyDisplay::prepared);
    connect(&m_computation, &Computation::stateChanged, this, &AccuracyDisplay::showPanel);
    connect(&m_document, &Document::scenarioChanged, this, &AccuracyDisplay::refresh);
    m_deck.accuracy().setFolder(AccuracyWork::folder());
    m_deck.accuracy().setRequest(m_kept.asked ? *m_kept.asked : rememberedComparison(m_deck.accuracy().request()));
    showOutcome();
    refresh();
    m_work.tellProgress();
}

AccuracyDisplay::~AccuracyDisplay() {
    m_kept.asked = m_deck.accuracy().request();
}

void AccuracyDisplay::showOutcome() {
    const auto& report = m_work.report();
    m_deck.accuracy().setError(m_kept.failure ? m_kept.failure->what() : QString(),
                               m_kept.failure ? m_kept.failure->remedy() : QString());
    m_deck.accuracy().setFindings(report != nullptr && !m_work.running() ? report->findings : Findings());
}

void AccuracyDisplay::prepared() {
    const void* fe = m_computation.inputs().fe.get();
    if (fe != m_kept.fe) {
        // Points of another result say nothing here.
        m_kept.fe = fe;
        m_work.clear();
        m_kept.failure.reset();
        showOutcome();
        if (fe != nullptr) {
            m_work.resume(m_computation.inputs(), m_document.scenario(), m_deck.accuracy().request());
        }
    }
    refresh();
    const bool ready =
        m_computation.results().clustering != nullptr && !m_computation.stale(Stage::Clusters, m_document.scenario());
    if (m_kept.compareWhenReady && ready && !m_work.running()) {
        m_kept.compareWhenReady = false;
        m_deck.choose(PanelDeck::Accuracy);
        compare();
    }
}

void AccuracyDisplay::compareWhenReady() {
    m_kept.compareWhenReady = true;
}

void AccuracyDisplay::compare() {
    widgets::AccuracyPanel& panel = m_deck.accuracy();
    const bool here = !panel.place().onCluster();
    if (m_computation.inputs().fe == nullptr || m_work.running() ||
        (here && (m_computation.busy(Stage::Simulation) || !m_busy.isEmpty()))) {
        return;
    }
    m_kept.failure.reset();
    panel.setError({});
    panel.setFindings({});
    try {
        const widgets::AccuracyPanel::Request request = panel.request();
        m_work.start(m_computation.inputs(), m_document.scenario(), request, jobCaseOf(m_document));
        rememberComparison(request);
    } catch (...) {
        m_kept.failure = failureOf(std::current_exception());
        showOutcome();
    }
    m_kept.fraction = 0.0;
    panel.setProgress(tr("Preparing"), 0.0, std::numeric_limits<double>::quiet_NaN());
    refresh();
    emit changed();
}

void AccuracyDisplay::cancel() {
    if (m_work.simulatesHere()) {
        m_work.cancel();
    } else if (mayCancelJob(&m_deck.accuracy())) {
        m_work.cluster().cancelJob();
    }
}

void AccuracyDisplay::setBusy(const QString& why) {
    if (why != m_busy) {
        m_busy = why;
        showPanel();
    }
}

void AccuracyDisplay::ended(const Failure* failure) {
    m_kept.failure = failure != nullptr ? std::optional(*failure) : std::nullopt;
    showOutcome();
    if (failure == nullptr && m_work.report() != nullptr) {
        m_session.tell(m_work.report()->complete
                           ? tr("Settings compared")
                           : tr("The comparison is not complete; what is done is kept, and comparing again goes on"));
    }
    refresh();
    emit changed();
}

void AccuracyDisplay::adopt(int row) {
    const auto& report = m_work.report();
    if (report == nullptr || m_document.empty()) {
        return;
    }
    if (stale()) {
        m_session.tell(tr("These points belong to other settings of the case: compare again before one is used."));
        return;
    }
    const AccuracyPoint& point =
        row == widgets::referenceRow ? report->reference : report->points.at(static_cast<std::size_t>(row));
    m_document.edit([setting = point.setting] { return tr("setting %1").arg(widgets::settingWords(setting)); }, point.scenario);
}

std::optional<int> AccuracyDisplay::rowInUse() const {
    const auto& report = m_work.report();
    if (report == nullptr || m_computation.inputs().fe == nullptr) {
        return std::nullopt;
    }
    const Digest key = originOf(m_computation.inputs(), m_document.scenario(), 0, 0.0, m_work.machine()).key;
    for (std::size_t i = 0; i < report->points.size(); ++i) {
        if (report->points[i].origin.key == key) {
            return static_cast<int>(i);
        }
    }
    return report->reference.origin.key == key ? std::optional(widgets::referenceRow) : std::nullopt;
}

bool AccuracyDisplay::stale() const {
    const auto& report = m_work.report();
    if (report == nullptr || m_computation.inputs().fe == nullptr || rowInUse()) {
        return false;
    }
    const Scenario reference = referenceScenario(m_document.scenario());
    return originOf(m_computation.inputs(), reference, 0, 0.0, m_work.machine()).key != report->reference.origin.key;
}

void AccuracyDisplay::refresh() {
    widgets::AccuracyPage::Content content;
    content.report = m_work.report();
    content.inUse = rowInUse();
    content.stale = stale();
    content.fpsTarget = m_document.scenario().grid.fpsTarget;
    content.running = m_work.running();
    m_page.setContent(content);
    showPanel();
}

void AccuracyDisplay::showPanel() {
    const auto& fe = m_computation.inputs().fe;
    const Results& results = m_computation.results();
    const bool none = results.fragments != nullptr && results.fragments->list.empty();
    const bool simulating = m_computation.busy(Stage::Simulation);
    const bool here = !m_deck.accuracy().place().onCluster();
    QString why;
    if (fe == nullptr) {
        why = tr("Open a result first.");
    } else if (none) {
        why = tr("No element dies in this result, so there is nothing to compare.");
    } else if (m_work.cluster().running()) {
        why = tr(
            "The cluster simulates. Times are not measured there: compare on this machine for them, no world is simulated again.");
    } else if (here && simulating) {
        why = tr("A run is being simulated: comparing beside it would spoil the times. Wait for it or cancel it.");
    } else if (here && !m_busy.isEmpty()) {
        why = m_busy;
    } else if (m_work.running()) {
        why = tr("Simulate waits until the comparison is through, so that its times hold. Settings can be edited meanwhile.");
    }
    m_deck.accuracy().setReady(fe != nullptr && !none && (!here || (!simulating && m_busy.isEmpty())), m_work.running(), why);
    showRail();
}

void AccuracyDisplay::showRail() {
    const auto& report = m_work.report();
    const bool old = report != nullptr && (!report->complete || stale());
    const widgets::StageState state = answerState(m_work.running(), report != nullptr, old);
    const std::int64_t found = report != nullptr ? static_cast<std::int64_t>(report->findings.list().size()) : 0;
    m_deck.rail().setState(PanelDeck::Accuracy, state, found, m_kept.fraction);
}

}  // namespace rubble
