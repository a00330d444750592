#include "app/gui/evidence/camera_overlay.h"

#include <QLocale>

#include "app/gui/session/computation.h"
#include "widgets/evidence/photo_view.h"
#include "widgets/figures/number_text.h"

namespace rubble {

namespace {

constexpr int drawEvery = 40;        // ms
constexpr int overlayPixels = 1800;  // longest side

}  // namespace

CameraOverlay::CameraOverlay(Computation& computation, EvidenceWork& work, widgets::PhotoView& photo,
                             std::function<render::SceneData()> scene, QObject* parent)
    : QObject(parent), m_computation(computation), m_work(work), m_photo(photo), m_scene(std::move(scene)) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(drawEvery);
    connect(&m_timer, &QTimer::timeout, this, &CameraOverlay::draw);
    connect(&m_work, &EvidenceWork::outlined, this, [this](const std::vector<std::vector<Eigen::Vector2d>>& outlines) {
        m_outlining = false;
        m_outlines = outlines;
        emit outlined();
    });
}

void CameraOverlay::drawLater(std::function<Wanted()> wanted) {
    m_wanted = std::move(wanted);
    if (!m_timer.isActive()) {
        m_timer.start();
    }
}

void CameraOverlay::draw() {
    const Wanted wanted = m_wanted();
    const auto show = m_photo.show();
    if (!wanted.match || m_computation.inputs().fe == nullptr || show == widgets::PhotoView::Show::Photograph) {
        m_photo.setOverlay({}, {});
        return;
    }
    const QString caption = tr("simulation, %1").arg(figures::timeText(wanted.like.time));
    if (show == widgets::PhotoView::Show::Outline) {
        const EvidenceRun run(m_computation.inputs(), m_computation.currentRun());
        m_photo.setOverlay({}, caption);
        if (run.trajectory != nullptr) {
            m_outlining = true;
            m_work.outline(run, wanted.match->camera, wanted.photograph, wanted.like.time, wanted.withFallen);
        }
        return;
    }
    try {
        const render::SceneData scene = m_scene();
        if (m_studio == nullptr || !(scene == m_studioScene)) {
            m_studio = std::make_unique<figures::CameraStudio>(scene);
            m_studioScene = scene;
        }
        m_photo.setOverlay(
            m_studio->picture(wanted.like, wanted.match->camera, wanted.photograph, overlayPixels, wanted.match->distance),
            caption);
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_photo.setOverlay({}, {});
        emit failed(failure->inOneLine());
    }
}

}  // namespace rubble
