#include "app/gui/stage/status_feed.h"

#include <unistd.h>

#include <QLocale>
#include <algorithm>
#include <fstream>
#include <limits>

#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "widgets/basics/wording.h"
#include "widgets/case/run_verdict.h"
#include "widgets/run/caution_words.h"
#include "widgets/run/health_list.h"
#include "widgets/views/status_line.h"

namespace rubble {

using Figure = widgets::StatusLine::Figure;

std::int64_t residentMemory() {
    std::ifstream file("/proc/self/statm");
    std::int64_t total = 0;
    std::int64_t resident = 0;
    return file >> total >> resident ? resident * sysconf(_SC_PAGESIZE) : 0;
}

StatusFeed::StatusFeed(Session& session, Playback& playback, const PanelDeck& deck, widgets::StatusLine& line, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_playback(playback),
      m_deck(deck),
      m_line(line),
      m_kept(session.part<Kept>()) {
    m_timer.setInterval(250);
    connect(&m_timer, &QTimer::timeout, this, &StatusFeed::refresh);
    m_timer.start();
    connect(&playback, &Playback::frameShown, this, [this](bool live) { (live ? m_kept.live : m_kept.shown).frame(now()); });
    connect(&playback.clock(), &widgets::PlaybackClock::playingChanged, this, [this](bool playing) {
        if (playing) {
            m_kept.shown.reset();
        }
    });
    connect(&m_computation, &Computation::runBegun, this, [this] { m_kept.live.reset(); });
    connect(&m_computation, &Computation::progressed, this, &StatusFeed::showProgress);
}

double StatusFeed::playbackRecent() const {
    return m_kept.shown.recent(now());
}

double StatusFeed::secondsLeft(double fraction, double spent) {
    const RunRecord* record = m_computation.currentRun();
    const bool simulating = record != nullptr && record->running && !record->live && record->results.clustering != nullptr &&
                            m_computation.inputs().fe != nullptr;
    if (simulating) {
        if (m_kept.run != record->reader.get()) {
            m_kept.run = record->reader.get();
            m_kept.ofRun =
                RunTimeLeft::of(*record->results.clustering, m_computation.inputs().fe->times().back(), record->scenario);
        }
        m_kept.ofRun.reached(record->newest, spent);
        return m_kept.ofRun.left().value_or(std::numeric_limits<double>::quiet_NaN());
    }
    return m_kept.left.after({{"status", "", {}}, fraction});
}

void StatusFeed::showProgress(const QString& what, double fraction) {
    if (what.isEmpty()) {
        m_kept.sinceStart.invalidate();
        m_line.setActivity({});
        return;
    }
    // A new stage starts its own clock.
    if (!m_kept.sinceStart.isValid() || fraction < m_kept.lastFraction) {
        m_kept.sinceStart.start();
        m_kept.left.restart();
    }
    m_kept.lastFraction = fraction;
    const double left = secondsLeft(fraction, static_cast<double>(m_kept.sinceStart.elapsed()) / 1000.0);
    const int waiting = m_computation.waiting();
    const QString queue = waiting > 0 ? QStringLiteral(" · ") + tr("%1 waiting").arg(waiting) : QString();
    m_line.setActivity(widgets::shownProgress(what, left) + queue, fraction);
}

void StatusFeed::showBodies() {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->reader->frameCount() == 0) {
        m_line.setFigure(Figure::Bodies, {}, {});
        return;
    }
    try {
        const auto frame = record->reader->frame(record->reader->frameAt(m_playback.clock().time()));
        const std::vector<BodyRecord> bodies = record->reader->bodies();
        std::int64_t present = 0;
        std::int64_t awake = 0;
        // As everywhere else: those that carry fragments, without the loose structure.
        for (std::size_t b = 0; b < frame->states.size(); ++b) {
            if (b < bodies.size() && bodies[b].isIsland()) {
                continue;
            }
            present += frame->states[b] != BodyState::Removed ? 1 : 0;
            awake += frame->states[b] == BodyState::Awake ? 1 : 0;
        }
        m_line.setFigure(Figure::Bodies, tr("Bodies"), widgets::shownCount(present),
                         tr("%1 awake").arg(widgets::shownCount(awake)));
    } catch (const std::exception&) {
        // The views say what is wrong with the run file; a figure is not worth a second complaint.
        m_line.setFigure(Figure::Bodies, {}, {});
    }
}

void StatusFeed::showFindings() {
    const std::int64_t found = m_deck.findings();
    m_line.setFigure(Figure::Findings, tr("Findings"), found > 0 ? widgets::shownCount(found) : QString());
    m_line.setFigureTip(Figure::Findings,
                        tr("The amber boxes of all panels; of evidence those of the photograph and the survey that are chosen. "
                           "Limits of health that a run passed are counted apart."));
}

void StatusFeed::showHealth() {
    const RunRecord* record = m_computation.currentRun();
    // Before the end nothing is sound yet, but a breach is one.
    if (record == nullptr || (record->outcome == nullptr && record->health().breaches.empty())) {
        m_line.setFigure(Figure::Health, {}, {});
        return;
    }
    const HealthReport& health = record->health();
    if (health.breaches.empty()) {
        m_line.setFigure(Figure::Health, tr("Health"), tr("no limit passed"));
        m_line.setFigureTip(Figure::Health, tr("No limit of the health monitor was passed in this run."));
        return;
    }
    const QString passed = widgets::limitsPassed(widgets::limitsIn(health));
    const bool acknowledged = record->acknowledged.has_value();
    const bool tainted = health.tainted() && !acknowledged;
    m_line.setFigure(Figure::Health, tainted ? QStringLiteral("⚠ ") + tr("Health") : tr("Health"), tainted ? tr("tainted") : passed,
                     acknowledged ? tr("acknowledged")
                     : tainted    ? passed
                                  : widgets::gradeWords(gravestGrade(health.breaches)),
                     tainted);
    QStringList titles;
    for (const PassedLimit& limit : passedLimits(health.breaches)) {
        titles << widgets::worded(health.breaches[limit.worst].what);
    }
    m_line.setFigureTip(Figure::Health, titles.join(QLatin1Char('\n')));
}

void StatusFeed::refresh() {
    const QLocale locale;
    const auto fps = [&](double value) { return locale.toString(value, 'f', value < 10.0 ? 1 : 0) + tr(" FPS"); };
    const RunRecord* record = m_computation.currentRun();
    if (m_playback.following()) {
        m_line.setFigure(Figure::Live, tr("Live"), fps(m_kept.live.recent(now())),
                         tr("target %1").arg(locale.toString(record->scenario.grid.fpsTarget, 'g', 4)));
    } else if (record != nullptr && record->live && m_kept.live.frames() > 1) {
        m_line.setFigure(Figure::Live, tr("Live"), fps(m_kept.live.mean()),
                         tr("mean, worst second %1").arg(locale.toString(m_kept.live.worstSecond(), 'f', 0)));
    } else {
        m_line.setFigure(Figure::Live, {}, {});
    }
    const bool playing = m_playback.clock().playing() && m_playback.picturesSeen();
    m_line.setFigure(Figure::Playback, tr("Playback"), playing ? fps(playbackRecent()) : QString());
    showBodies();
    const bool done = record != nullptr && record->outcome != nullptr;
    m_line.setFigure(Figure::Step, tr("Step"),
                     done ? widgets::shownNumber(record->outcome->stepTimes.meanMs, 2) + tr(" ms") : QString());
    m_line.setFigure(Figure::Energy, tr("Energy"),
                     done ? QStringLiteral("+") + widgets::shownShare(record->outcome->energy.drift, 2) : QString());
    showHealth();
    showFindings();
    const double gib = static_cast<double>(residentMemory()) / (1024.0 * 1024.0 * 1024.0);
    m_line.setFigure(Figure::Memory, tr("Memory"), gib > 0.0 ? locale.toString(gib, 'f', 2) + tr(" GiB") : QString());
}

}  // namespace rubble
