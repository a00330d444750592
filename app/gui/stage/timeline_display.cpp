#include "app/gui/stage/timeline_display.h"

#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>
#include <cmath>

#include "app/gui/session/document.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/playback.h"
#include "widgets/figures/number_text.h"
#include "widgets/views/bookmark_editor.h"
#include "widgets/views/timeline.h"
#include "widgets/views/transport.h"

namespace rubble {

namespace {

// s. Nearer than this, two instants are the same to the eye.
constexpr double sameInstant = 1e-3;

QString shortened(const std::string& note) {
    const QString text = QString::fromStdString(note).simplified();
    return text.size() > 30 ? text.left(29) + QChar(0x2026) : text;
}

/// The file name of a photograph.
QString nameOf(const Case& theCase, const Photograph& photograph) {
    for (const CaseInput& input : theCase.inputs) {
        if (input.id == photograph.input) {
            return QFileInfo(QString::fromStdString(input.path)).fileName();
        }
    }
    return {};
}

}  // namespace

TimelineDisplay::TimelineDisplay(Document& document, Playback& playback, widgets::Timeline& timeline, widgets::Transport& transport,
                                 Actions& actions, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_playback(playback),
      m_timeline(timeline),
      m_editor(new widgets::BookmarkEditor(&timeline)) {
    connect(&document, &Document::replaced, this, &TimelineDisplay::refresh);
    connect(&document, &Document::bookmarksChanged, this, &TimelineDisplay::refresh);
    connect(&document, &Document::photographsChanged, this, &TimelineDisplay::refresh);
    connect(&timeline, &widgets::Timeline::bookmarkChosen, this,
            [this](std::size_t i) { m_playback.scrub(m_document.theCase().bookmarks[i].time); });
    connect(&timeline, &widgets::Timeline::bookmarkOpened, this, &TimelineDisplay::edit);
    connect(&transport, &widgets::Transport::bookmarkRequested, this, &TimelineDisplay::mark);
    connect(m_editor, &widgets::BookmarkEditor::noteChosen, this, [this](const QString& note) { setNote(m_edited, note); });
    connect(m_editor, &widgets::BookmarkEditor::removeRequested, this, [this] { remove(m_edited); });
    connectActions(actions);
    actions[ActionId::Loop].setChecked(playback.looping());
    refresh();
}

TimelineDisplay::~TimelineDisplay() = default;

void TimelineDisplay::connectActions(Actions& actions) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::PlayBackwards, [this] { m_playback.toggleBackwards(); });
    on(ActionId::Loop, [this](bool loop) { m_playback.setLooping(loop); });
    on(ActionId::LoopFrom, [this] {
        const double end = m_playback.loopRange() ? m_playback.loopRange()->second : m_playback.clock().last();
        const double now = m_playback.clock().time();
        m_playback.setLoopRange(now, end > now ? end : m_playback.clock().last());
    });
    on(ActionId::LoopTo, [this] {
        const double start = m_playback.loopRange() ? m_playback.loopRange()->first : m_playback.clock().first();
        const double now = m_playback.clock().time();
        m_playback.setLoopRange(start < now ? start : m_playback.clock().first(), now);
    });
    on(ActionId::Bookmark, [this] { mark(); });
    on(ActionId::PreviousBookmark, [this] { jump(false); });
    on(ActionId::NextBookmark, [this] { jump(true); });
    connect(&m_playback, &Playback::loopChanged, this,
            [this, &actions] { actions[ActionId::Loop].setChecked(m_playback.looping()); });
    // How times are counted and where scrubbing stops are habits of the user.
    const auto habit = [&](ActionId id, auto set) {
        QAction& action = actions[id];
        const QString key = action.objectName();
        action.setChecked(QSettings().value(key, false).toBool());
        set(action.isChecked());
        connect(&action, &QAction::triggered, this, [key, set](bool checked) {
            QSettings().setValue(key, checked);
            set(checked);
        });
    };
    habit(ActionId::Snap, [this](bool snaps) { m_playback.setSnapping(snaps); });
    habit(ActionId::TimeFromZero, [this](bool fromZero) { m_playback.setFromZero(fromZero); });
}

void TimelineDisplay::refresh() {
    std::vector<widgets::TimeMark> marks;
    for (const Bookmark& each : m_document.theCase().bookmarks) {
        marks.push_back({each.time, QString::fromStdString(each.note)});
    }
    m_timeline.setBookmarks(std::move(marks));
    std::vector<widgets::PhotographTime> photographs;
    for (const Photograph& each : m_document.theCase().photographs) {
        if (each.time) {
            photographs.push_back({*each.time, each.timeUncertainty, nameOf(m_document.theCase(), each)});
        }
    }
    m_timeline.setPhotographs(std::move(photographs));
}

void TimelineDisplay::mark() {
    if (m_document.empty() || m_playback.clock().last() <= m_playback.clock().first()) {
        return;
    }
    const double now = m_playback.clock().time();
    const auto nearest = [&] {
        const auto& all = m_document.theCase().bookmarks;
        return std::find_if(all.begin(), all.end(), [&](const Bookmark& each) { return std::abs(each.time - now) < sameInstant; });
    };
    if (nearest() == m_document.theCase().bookmarks.end()) {
        std::vector<Bookmark> all = m_document.theCase().bookmarks;
        all.push_back({now, {}});
        m_document.setBookmarks(std::move(all),
                                [at = now - m_playback.timeOrigin()] { return tr("bookmark at %1").arg(figures::timeText(at)); });
    }
    edit(static_cast<std::size_t>(nearest() - m_document.theCase().bookmarks.begin()));
}

void TimelineDisplay::edit(std::size_t bookmark) {
    const auto& all = m_document.theCase().bookmarks;
    if (bookmark >= all.size()) {
        return;
    }
    m_edited = bookmark;
    m_editor->open(tr("Bookmark at %1").arg(figures::timeText(all[bookmark].time - m_playback.timeOrigin())),
                   QString::fromStdString(all[bookmark].note), m_timeline.mapToGlobal(m_timeline.flagOf(bookmark).toPoint()));
}

void TimelineDisplay::setNote(std::size_t bookmark, const QString& note) {
    std::vector<Bookmark> all = m_document.theCase().bookmarks;
    if (bookmark < all.size()) {
        all[bookmark].note = note.toStdString();
        m_document.setBookmarks(std::move(all), [name = shortened(note.toStdString())] { return tr("bookmark “%1”").arg(name); });
    }
}

void TimelineDisplay::remove(std::size_t bookmark) {
    std::vector<Bookmark> all = m_document.theCase().bookmarks;
    if (bookmark < all.size()) {
        const QString name = shortened(all[bookmark].note);
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(bookmark));
        m_document.setBookmarks(std::move(all),
                                [name] { return name.isEmpty() ? tr("bookmark removed") : tr("bookmark “%1” removed").arg(name); });
    }
}

void TimelineDisplay::jump(bool forward) {
    const auto& all = m_document.theCase().bookmarks;
    const double now = m_playback.clock().time();
    const Bookmark* to = nullptr;
    for (const Bookmark& each : all) {
        if (forward && each.time > now + sameInstant) {
            to = &each;
            break;
        }
        if (!forward && each.time < now - sameInstant) {
            to = &each;
        }
    }
    if (to != nullptr) {
        m_playback.scrub(to->time);
    }
}

}  // namespace rubble
