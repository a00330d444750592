#include "app/gui/run/health_display.h"

#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "core/fe/frame_transform.h"
#include "widgets/run/health_list.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

/// Elements of what a body carries at any time: the worst body of a breach may be born after the breach began.
std::vector<ElementIndex> elementsOf(const RunRecord& record, BodyId body) {
    std::vector<ElementIndex> elements;
    if (record.reader == nullptr || record.results.fragments == nullptr) {
        return elements;
    }
    for (const Carrier& carrier : record.reader->carriers()) {
        if (carrier.body == body) {
            elements.push_back(record.results.fragments->list[at(carrier.fragment)].element);
        }
    }
    for (const IslandRecord& island : record.reader->islands()) {
        if (island.body == body) {
            elements.insert(elements.end(), island.elements.begin(), island.elements.end());
        }
    }
    return elements;
}

}  // namespace

HealthDisplay::HealthDisplay(Session& session, PanelDeck& deck, Playback& playback, ViewArea& area, widgets::Timeline& timeline,
                             QObject* parent)
    : QObject(parent),
      m_session(session),
      m_computation(session.computation()),
      m_deck(deck),
      m_playback(playback),
      m_area(area),
      m_timeline(timeline) {
    connect(&timeline, &widgets::Timeline::markChosen, this, [this](std::size_t mark) {
        m_deck.choose(PanelDeck::Run);
        show(mark, false);
    });
    connect(&deck.run().health(), &widgets::HealthList::breachChosen, this, [this](std::size_t breach) { show(breach, true); });
    connect(&deck.run().health(), &widgets::HealthList::acknowledgeRequested, &m_computation, &Computation::acknowledge);
    // Once the button has done with its click: the list is made anew.
    connect(&session.document(), &Document::scenarioChanged, this, &HealthDisplay::refresh, Qt::QueuedConnection);
    connect(&m_computation, &Computation::acknowledged, this, &HealthDisplay::acknowledged);
    connect(&m_computation, &Computation::runBegun, this, [this] {
        clearSelection();
        refresh();
    });
    connect(&m_computation, &Computation::runGrew, this, &HealthDisplay::showMarks);
    connect(&m_computation, &Computation::runEnded, this, &HealthDisplay::refresh);
}

void HealthDisplay::refresh() {
    showMarks();
    const RunRecord* record = m_computation.currentRun();
    const bool stopped = record != nullptr && record->outcome == nullptr && !record->running && record->reader != nullptr;
    if (record == nullptr || (record->outcome == nullptr && !stopped)) {
        m_deck.run().setHealth(std::nullopt);
        return;
    }
    widgets::HealthList::Content content{record->health(), record->acknowledged, origin(), record->grounds(),
                                         m_session.document().scenario()};
    if (stopped) {
        content.upTo = record->newest;
    }
    m_deck.run().setHealth(content);
}

void HealthDisplay::showMarks() {
    const RunRecord* record = m_computation.currentRun();
    m_timeline.setHealth(record == nullptr ? std::vector<widgets::HealthMark>()
                                           : widgets::healthMarks(record->health(), record->acknowledged.has_value(), origin()));
}

// As exports add it: the origin of the frame, z up.
Vec3 HealthDisplay::origin() const {
    return FrameTransform(m_computation.inputs().frame).localZero();
}

void HealthDisplay::show(std::size_t breach, bool near) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || breach >= record->health().breaches.size()) {
        return;
    }
    const HealthBreach& shown = record->health().breaches[breach];
    m_playback.clock().pause();
    m_playback.scrub(shown.from);
    render::View view = m_area.views().view();
    view.selection = shown.body ? elementsOf(*record, *shown.body) : std::vector<ElementIndex>();
    m_area.views().setView(view);
    if (near && shown.body && shown.place.allFinite()) {
        m_area.views().centreOn(shown.place);
    }
}

void HealthDisplay::clearSelection() {
    render::View view = m_area.views().view();
    view.selection.clear();
    m_area.views().setView(view);
}

void HealthDisplay::acknowledged(const QString& complaint) {
    if (complaint.isEmpty()) {
        refresh();
    } else {
        m_deck.run().health().setComplaint(complaint);
    }
}

}  // namespace rubble
