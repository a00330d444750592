#include "app/gui/views/camera_keys.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "widgets/figures/camera_path.h"
#include "widgets/figures/number_text.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

constexpr double sameInstantOfKey = 1e-3;  // s

/// What outlives the window.
struct KeptLook {
    bool looking = false;
};

}  // namespace

CameraKeys::CameraKeys(Session& session, Playback& playback, ViewArea& area, widgets::Timeline& timeline, Actions& actions,
                       QObject* parent)
    : QObject(parent),
      m_document(session.document()),
      m_playback(playback),
      m_area(area),
      m_timeline(timeline),
      m_actions(actions),
      m_looking(session.part<KeptLook>().looking) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::CameraKey, [this] { setHere(); });
    on(ActionId::RemoveCameraKey, [this] { removeHere(); });
    on(ActionId::AlongCameraKeys, [this](bool along) {
        m_looking = along;
        lookHere();
    });
    connect(&m_document, &Document::cameraKeysChanged, this, &CameraKeys::refresh);
    connect(&m_document, &Document::replaced, this, [this] {
        m_looking = false;
        refresh();
    });
    connect(&playback.clock(), &widgets::PlaybackClock::timeChanged, this, [this] {
        lookHere();
        m_actions.enable(ActionId::RemoveCameraKey, keyHere() < keys().size());
    });
    refresh();
}

const std::vector<CameraKey>& CameraKeys::keys() const {
    return m_document.theCase().cameraKeys;
}

std::size_t CameraKeys::keyHere() const {
    const double now = m_playback.clock().time();
    const auto found = std::find_if(keys().begin(), keys().end(),
                                    [now](const CameraKey& key) { return std::abs(key.time - now) < sameInstantOfKey; });
    return static_cast<std::size_t>(found - keys().begin());
}

void CameraKeys::setHere() {
    const render::View& view = m_area.views().view();
    const double now = m_playback.clock().time();
    std::vector<CameraKey> after = keys();
    const CameraKey key = figures::keyOf(render::cameraOf(view, render::PaneContent::Fragments), now);
    if (const std::size_t here = keyHere(); here < after.size()) {
        after[here] = key;
    } else {
        after.push_back(key);
    }
    m_document.setCameraKeys(std::move(after),
                             [at = now - m_playback.timeOrigin()] { return tr("camera key at %1").arg(figures::timeText(at)); });
}

void CameraKeys::removeHere() {
    std::vector<CameraKey> after = keys();
    const std::size_t here = keyHere();
    if (here < after.size()) {
        after.erase(after.begin() + static_cast<std::ptrdiff_t>(here));
        m_document.setCameraKeys(std::move(after), [] { return tr("camera key removed"); });
    }
}

void CameraKeys::lookHere() {
    if (!m_looking || keys().empty()) {
        return;
    }
    render::View view = m_area.views().view();
    figures::lookAlong(view, keys(), m_playback.clock().time());
    m_area.views().setView(view);
}

void CameraKeys::refresh() {
    std::vector<double> times;
    for (const CameraKey& key : keys()) {
        times.push_back(key.time);
    }
    m_timeline.setCameraKeys(std::move(times));
    const bool have = m_area.views().data().fe != nullptr;
    m_looking = m_looking && !keys().empty();
    m_actions.enable(ActionId::CameraKey, have);
    m_actions.enable(ActionId::RemoveCameraKey, have && keyHere() < keys().size());
    m_actions.enable(ActionId::AlongCameraKeys, have && !keys().empty());
    m_actions[ActionId::AlongCameraKeys].setChecked(m_looking);
    lookHere();
}

}  // namespace rubble
