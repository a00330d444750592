#include "app/gui/stage/playback.h"

#include <algorithm>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "core/trajectory/island_times.h"
#include "widgets/basics/wording.h"
#include "widgets/views/timeline.h"
#include "widgets/views/transport.h"
#include "widgets/views/view_widget.h"

namespace rubble {

Playback::Playback(Session& session, widgets::ViewWidget& view, widgets::Timeline& timeline, widgets::Transport& transport,
                   Actions& actions, QObject* parent)
    : QObject(parent),
      m_computation(session.computation()),
      m_view(view),
      m_timeline(timeline),
      m_transport(transport),
      m_kept(session.part<Kept>()),
      m_clock(m_kept.clock) {
    connect(&m_clock, &widgets::PlaybackClock::timeChanged, this, [this](double time) {
        m_view.setTime(time);
        m_timeline.setTime(time);
        m_transport.setTime(time);
    });
    connect(&m_clock, &widgets::PlaybackClock::playingChanged, this, [this](bool playing) {
        m_transport.setBackwards(m_clock.backwards());
        m_transport.setPlaying(playing || m_kept.following);
    });
    connect(&m_clock, &widgets::PlaybackClock::rangeChanged, this, &Playback::showLoop);
    connect(&m_transport, &widgets::Transport::playBackToggled, this, &Playback::toggleBackwards);
    connect(&m_transport, &widgets::Transport::loopToggled, this, &Playback::setLooping);
    connect(&m_timeline, &widgets::Timeline::loopDragged, this, [this](double from, double to, bool) { setLoopRange(from, to); });
    connect(&m_clock, &widgets::PlaybackClock::rateChanged, &m_transport, &widgets::Transport::setRate);
    connect(&m_timeline, &widgets::Timeline::scrubbed, this, &Playback::scrub);
    connect(&m_transport, &widgets::Transport::playToggled, this, &Playback::toggle);
    connect(&m_transport, &widgets::Transport::stepped, this, &Playback::step);
    connect(&m_transport, &widgets::Transport::jumpedToFirst, this, &Playback::jumpToFirst);
    connect(&m_transport, &widgets::Transport::jumpedToLast, this, &Playback::jumpToLast);
    connect(&m_transport, &widgets::Transport::ratePicked, &m_clock, &widgets::PlaybackClock::setRate);
    connect(&m_view, &widgets::ViewWidget::shown, this, &Playback::shown);
    connect(&m_computation, &Computation::runBegun, this, &Playback::runBegun);
    connect(&m_computation, &Computation::runGrew, this, &Playback::runGrew);
    connect(&m_growth, &widgets::PictureTurn::due, this, [this] {
        if (const RunRecord* record = m_computation.currentRun(); m_kept.following && record != nullptr) {
            m_clock.setTime(record->newest);
        }
    });
    connect(&m_computation, &Computation::runEnded, this, &Playback::runEnded);
    // Once all is shown of it.
    connect(&m_computation, &Computation::runReopened, this, &Playback::runReopened, Qt::QueuedConnection);
    connect(&m_computation, &Computation::runReopened, this, &Playback::showIslands);
    connectActions(actions);
}

void Playback::connectActions(Actions& actions) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::Play, [this] { toggle(); });
    on(ActionId::Back, [this] { step(-1); });
    on(ActionId::Forward, [this] { step(1); });
    on(ActionId::BackTen, [this] { step(-10); });
    on(ActionId::ForwardTen, [this] { step(10); });
    on(ActionId::First, [this] { jumpToFirst(); });
    on(ActionId::Last, [this] { jumpToLast(); });
}

bool Playback::picturesSeen() const {
    return m_view.isVisible();
}

void Playback::reset() {
    m_kept.following = false;
    m_clock.pause();
    m_clock.setNewest({});
    m_kept.loopRange.reset();
    refresh(false);
    setFromZero(m_kept.fromZero);
    showLoop();
    const auto& fe = m_computation.inputs().fe;
    m_clock.setTime(fe != nullptr && fe->stateCount() > 0 ? fe->times().front() : 0.0);
    m_timeline.setTime(m_clock.time());
    m_transport.setTime(m_clock.time());
    m_view.setTime(m_clock.time());
    showDeaths();
}

void Playback::goOn() {
    refresh(m_kept.runStale);
    setFromZero(m_kept.fromZero);
    showLoop();
    showDeaths();
    m_timeline.setTime(m_clock.time());
    m_transport.setTime(m_clock.time());
    m_transport.setRate(m_clock.rate());
    m_transport.setBackwards(m_clock.backwards());
    m_transport.setPlaying(m_clock.playing() || m_kept.following);
    m_view.setTime(m_clock.time());
}

void Playback::showDeaths() {
    const auto& fe = m_computation.inputs().fe;
    if (fe == nullptr) {
        return;
    }
    std::vector<double> deaths(fe->stateCount(), 0.0);
    for (std::size_t k = 1; k < deaths.size(); ++k) {
        const auto before = static_cast<double>(fe->activity().activeCount(k - 1));
        deaths[k] = std::max(0.0, before - static_cast<double>(fe->activity().activeCount(k)));
    }
    m_timeline.setDeaths(fe->times(), deaths);
    showIslands();
}

/// Of a run that goes on too: what its file says by now.
void Playback::showIslands() {
    const auto& fe = m_computation.inputs().fe;
    const RunRecord* record = m_computation.currentRun();
    if (fe == nullptr || record == nullptr || record->reader == nullptr) {
        m_timeline.setIslands({}, {});
        return;
    }
    IslandTimes islands;
    try {
        islands = islandTimes(*record->reader, fe->mesh().elementCount());
    } catch (const std::exception&) {
        // The views say what is wrong with the run file.
    }
    std::vector<widgets::HandOverMark> marks;
    for (const IslandTimes::HandOver& each : islands.handOvers) {
        marks.push_back({each.time, tr("loose structure went over to the engine: islands %1, elements %2, %3")
                                        .arg(widgets::shownCount(static_cast<std::int64_t>(each.islands)),
                                             widgets::shownCount(static_cast<std::int64_t>(each.elements)),
                                             widgets::shownWith(each.mass, "kg"))});
    }
    m_timeline.setIslands(marks.empty() ? std::vector<double>() : islands.deathsByState(fe->activity(), fe->times()),
                          std::move(marks));
}

void Playback::refresh(bool runStale) {
    m_kept.runStale = runStale;
    const auto& fe = m_computation.inputs().fe;
    m_transport.setAvailable(fe != nullptr);
    if (fe == nullptr || fe->stateCount() == 0) {
        m_clock.setRange(0.0, 0.0);
        m_timeline.setRange(0.0, 0.0);
        m_transport.setSpan(0.0, 0.0);
        return;
    }
    const double first = fe->times().front();
    const double feEnd = fe->times().back();
    const RunRecord* record = m_computation.currentRun();
    const double last = record != nullptr ? std::max(feEnd, record->newest) : feEnd;
    m_clock.setRange(first, last);
    const bool running = record != nullptr && record->running;
    // While it runs nobody knows the end: the axis shows the latest that it may be.
    const double axisEnd = running ? feEnd + record->scenario.simulation.settleTime : last;
    m_timeline.setRange(first, std::max(last, axisEnd));
    m_timeline.setFeEnd(feEnd);
    m_timeline.setComputed(first, record != nullptr ? record->newest : first, runStale);
    m_transport.setSpan(last, feEnd, fe->contents().looseBodies);
}

// Where nothing has died yet there is nothing to see of a run.
void Playback::runReopened() {
    const RunRecord* record = m_computation.currentRun();
    const FragmentSet* fragments = record != nullptr ? record->results.fragments.get() : nullptr;
    if (fragments != nullptr && !fragments->list.empty() && m_clock.time() <= fragments->list.front().handOverTime) {
        scrub(record->newest);
    }
}

void Playback::runBegun() {
    const RunRecord& record = *m_computation.currentRun();
    m_clock.pause();
    refresh(false);
    showIslands();
    m_clock.setTime(m_clock.first());
    m_clock.setNewest(record.newest);
    m_kept.following = record.live;
    m_transport.setPlaying(m_kept.following);
    if (!record.live) {
        m_clock.play();
    }
}

void Playback::runGrew(double time) {
    refresh(m_kept.runStale);
    m_clock.setNewest(time);
    const std::shared_ptr<LivePace> pace = m_computation.livePace();
    if (m_kept.following) {
        m_growth.ask();
        // A hidden window draws nothing, and must not hold the run up.
        if (!m_view.isVisible() || m_view.window()->isMinimized()) {
            pace->shown(time);
        }
    } else if (pace != nullptr) {
        pace->shown(time);
    }
}

void Playback::runEnded() {
    const bool followed = m_kept.following;
    m_kept.following = false;
    m_clock.setNewest({});
    refresh(m_kept.runStale);
    showIslands();
    m_transport.setPlaying(m_clock.playing());
    if (followed) {
        m_clock.setTime(m_computation.currentRun()->newest);
    }
}

void Playback::shown(double time) {
    if (m_kept.following && m_computation.livePace() != nullptr) {
        m_computation.livePace()->shown(time);
        emit frameShown(true);
    } else if (m_clock.playing()) {
        emit frameShown(false);
    }
}

void Playback::leaveLive() {
    m_kept.following = false;
    m_transport.setPlaying(m_clock.playing());
    if (const auto& pace = m_computation.livePace()) {
        pace->shown(m_clock.last());
    }
}

std::vector<double> Playback::stops() const {
    const auto& fe = m_computation.inputs().fe;
    if (fe == nullptr) {
        return {};
    }
    std::vector<double> times = fe->times();
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr) {
        return times;
    }
    // After the last FE state the recorded frames take the place of states.
    for (std::size_t i = record->reader->frameAt(times.back()); i < record->reader->frameCount(); ++i) {
        if (record->reader->frameTime(i) > times.back()) {
            times.push_back(record->reader->frameTime(i));
        }
    }
    return times;
}

void Playback::step(int states) {
    const std::vector<double> times = stops();
    if (times.empty()) {
        return;
    }
    leaveLive();
    m_clock.pause();
    const double now = m_clock.time();
    const double slack = 1e-9 * std::max(1.0, std::abs(now));
    std::ptrdiff_t at = 0;
    if (states > 0) {
        at = std::upper_bound(times.begin(), times.end(), now + slack) - times.begin() + states - 1;
    } else {
        at = std::lower_bound(times.begin(), times.end(), now - slack) - times.begin() + states;
    }
    m_clock.setTime(
        times[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, static_cast<std::ptrdiff_t>(times.size()) - 1))]);
}

void Playback::jumpToFirst() {
    leaveLive();
    m_clock.setTime(m_clock.first());
}

void Playback::jumpToLast() {
    const RunRecord* record = m_computation.currentRun();
    if (record != nullptr && record->running) {
        // The end of a run that grows is its newest frame; in live mode it is followed again.
        m_kept.following = record->live;
        m_transport.setPlaying(m_kept.following || m_clock.playing());
        m_clock.setTime(record->newest);
    } else {
        m_clock.setTime(m_clock.last());
    }
}

void Playback::toggle() {
    if (m_kept.following) {
        leaveLive();
    } else if (m_clock.playing() && m_clock.backwards()) {
        m_clock.play();
    } else {
        m_clock.toggle();
    }
}

void Playback::scrub(double time) {
    leaveLive();
    const std::vector<double> times = m_kept.snapping ? stops() : std::vector<double>();
    if (!times.empty()) {
        const auto after = std::lower_bound(times.begin(), times.end(), time);
        const bool before = after == times.end() || (after != times.begin() && time - *(after - 1) < *after - time);
        time = before ? *(after - 1) : *after;
    }
    m_clock.setTime(time);
}

void Playback::showInstant(double time) {
    m_clock.pause();
    scrub(time);
}

void Playback::toggleBackwards() {
    leaveLive();
    if (m_clock.playing() && m_clock.backwards()) {
        m_clock.pause();
    } else {
        m_clock.play(true);
    }
}

void Playback::setLooping(bool loop) {
    m_kept.looping = loop;
    showLoop();
}

void Playback::setLoopRange(double from, double to) {
    m_kept.loopRange = to > from ? std::optional(std::pair(from, to)) : std::nullopt;
    m_kept.looping = m_kept.loopRange.has_value();
    showLoop();
}

void Playback::showLoop() {
    std::optional<std::pair<double, double>> range;
    if (m_kept.looping) {
        range = m_kept.loopRange.value_or(std::pair(m_clock.first(), m_clock.last()));
    }
    m_clock.setLoop(range);
    m_timeline.setLoop(m_clock.loop());
    m_transport.setLooping(m_kept.looping);
    emit loopChanged();
}

double Playback::timeOrigin() const {
    const auto& fe = m_computation.inputs().fe;
    return m_kept.fromZero && fe != nullptr && fe->stateCount() > 0 ? fe->times().front() : 0.0;
}

void Playback::setFromZero(bool fromZero) {
    m_kept.fromZero = fromZero;
    m_transport.setTimeOrigin(timeOrigin());
    m_timeline.setTimeOrigin(timeOrigin());
    render::View view = m_view.view();
    view.timeOrigin = timeOrigin();
    m_view.setView(view);
}

}  // namespace rubble
