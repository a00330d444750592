#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/gui/evidence/evidence_work.h"
#include "widgets/figures/camera_picture.h"

namespace rubble {

class Computation;
namespace widgets {
class PhotoView;
}

/// What the simulation shows from a matched camera, laid over its photograph: made anew, at most every few hundredths of a second,
/// as time, run or camera change.
class CameraOverlay : public QObject {
    Q_OBJECT

public:
    /// @param scene  what the views show
    CameraOverlay(Computation& computation, EvidenceWork& work, widgets::PhotoView& photo, std::function<render::SceneData()> scene,
                  QObject* parent = nullptr);

    struct Wanted {
        std::optional<CameraMatch> match;  ///< unset: nothing can be seen
        QSize photograph;                  ///< px
        render::View like;                 ///< time, colours, theme
        bool withFallen = true;
    };
    /// Asks for a picture; `wanted` is called when it is made.
    void drawLater(std::function<Wanted()> wanted);
    bool settled() const { return !m_timer.isActive() && !m_outlining; }
    const std::vector<std::vector<Eigen::Vector2d>>& outlines() const { return m_outlines; }
    void dropOutlines() { m_outlines.clear(); }

signals:
    void outlined();
    void failed(const QString& why);

private:
    void draw();

    Computation& m_computation;
    EvidenceWork& m_work;
    widgets::PhotoView& m_photo;
    std::function<render::SceneData()> m_scene;
    std::function<Wanted()> m_wanted;
    std::unique_ptr<figures::CameraStudio> m_studio;
    render::SceneData m_studioScene;
    std::vector<std::vector<Eigen::Vector2d>> m_outlines;
    bool m_outlining = false;
    QTimer m_timer;
};

}  // namespace rubble
