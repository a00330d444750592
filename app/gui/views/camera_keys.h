#pragma once

#include <QObject>
#include <vector>

#include "core/scenario/case.h"

namespace rubble {

class Actions;
class Document;
class Playback;
class Session;
class ViewArea;
namespace widgets {
class Timeline;
}

/// The keys between which the camera of a movie moves: sets and removes them at the instant shown, shows them in the timeline, and
/// lets the views look along them.
class CameraKeys : public QObject {
    Q_OBJECT

public:
    CameraKeys(Session& session, Playback& playback, ViewArea& area, widgets::Timeline& timeline, Actions& actions,
               QObject* parent = nullptr);

    /// The views look along the keys while time goes on.
    bool looking() const { return m_looking; }
    void refresh();

private:
    const std::vector<CameraKey>& keys() const;
    /// The key at the instant shown; the count of them if there is none.
    std::size_t keyHere() const;
    void setHere();
    void removeHere();
    void lookHere();

    Document& m_document;
    Playback& m_playback;
    ViewArea& m_area;
    widgets::Timeline& m_timeline;
    Actions& m_actions;
    bool& m_looking;
};

}  // namespace rubble
