#include <algorithm>

#include "widgets/figures/overlay/overlay.h"
#include "widgets/render/panes.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr std::size_t planCamera = static_cast<std::size_t>(render::PaneContent::Plan);
constexpr double flightMs = 200.0;

}  // namespace

void ViewWidget::setCamera(std::size_t index, const render::Camera& camera) {
    m_flight.stop();
    noteMove();
    m_moved[index] = true;
    m_view.cameras[index] = camera;
    update();
    emit viewChanged(m_view);
}

double ViewWidget::heightShare(const render::Pane& pane) const {
    const double room =
        figures::overlayRoom(figures::longestOverlay(m_view, m_scene, pane), pane.width, 13.0 * devicePixelRatioF());
    return pane.height > 0 ? std::max(0.5, 1.0 - 2.0 * room / pane.height) : 1.0;
}

/// Those that nobody has moved fit the panes that they are seen in; the others stay.
ViewWidget::Cameras ViewWidget::fitted(const Cameras& from) const {
    const QSize size = devicePixels();
    Cameras cameras = from;
    for (const render::Pane& pane : render::panesOf(m_view.layout, size.width(), size.height())) {
        const std::size_t index = render::cameraIndex(m_view, pane.content);
        if (!m_moved[index]) {
            cameras[index] = render::refit(from[index], m_scene.bounds(), pane.aspect(), heightShare(pane));
        }
    }
    return cameras;
}

void ViewWidget::fit() {
    m_moved = {};
    flyTo(fitted(m_view.cameras));
}

void ViewWidget::keepFitted() {
    setMoved({});
}

void ViewWidget::setMoved(const Moved& moved) {
    m_moved = moved;
    refit();
}

/// What is in flight is there at once where its end would not fit any more.
void ViewWidget::refit() {
    const Cameras& settled = m_flight.isActive() ? m_flightTo : m_view.cameras;
    const Cameras cameras = fitted(settled);
    if (!std::equal(cameras.begin(), cameras.end(), settled.begin(), render::showsAlike)) {
        m_flight.stop();
        m_view.cameras = cameras;
        update();
        emit viewChanged(m_view);
    }
}

/// A camera that is set to another place counts as moved, unless it joins one that is fitted.
void ViewWidget::takeMoved(const Cameras& cameras) {
    const Moved before = m_moved;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (cameras[i] != m_view.cameras[i]) {
            m_flight.stop();
            const auto joined = std::find(m_view.cameras.begin(), m_view.cameras.end(), cameras[i]);
            m_moved[i] = joined == m_view.cameras.end() || before[static_cast<std::size_t>(joined - m_view.cameras.begin())];
        }
    }
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
    // The base draws at once.
    refit();
    QOpenGLWidget::resizeEvent(event);
}

void ViewWidget::look(render::Preset preset) {
    const QSize size = devicePixels();
    Cameras cameras = m_view.cameras;
    for (const render::Pane& pane : render::panesOf(m_view.layout, size.width(), size.height())) {
        const std::size_t index = render::cameraIndex(m_view, pane.content);
        if (index != planCamera) {
            const bool parallel = cameras[index].parallel;
            cameras[index] = render::withProjection(render::fitCamera(m_scene.bounds(), pane.aspect(), preset), parallel);
            m_moved[index] = false;
        }
    }
    flyTo(fitted(cameras));
}

void ViewWidget::centreOn(const Vec3& point) {
    Cameras cameras = m_view.cameras;
    for (render::Camera& camera : cameras) {
        camera = render::centreOn(camera, point);
    }
    m_moved = everyCamera;
    flyTo(cameras);
}

void ViewWidget::centreNow(const Vec3& point) {
    m_flight.stop();
    noteMove();
    m_moved = everyCamera;
    for (render::Camera& camera : m_view.cameras) {
        camera = render::centreOn(camera, point);
    }
    update();
    emit viewChanged(m_view);
}

void ViewWidget::setParallel(bool parallel) {
    m_flight.stop();
    for (std::size_t i = 0; i < m_view.cameras.size(); ++i) {
        if (i != planCamera) {
            m_view.cameras[i] = render::withProjection(m_view.cameras[i], parallel);
        }
    }
    m_view.cameras = fitted(m_view.cameras);
    update();
    emit viewChanged(m_view);
}

void ViewWidget::turn(double yaw, double pitch) {
    Cameras cameras = m_view.cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (i != planCamera) {
            cameras[i] = render::orbit(cameras[i], yaw, pitch);
            m_moved[i] = true;
        }
    }
    flyTo(cameras);
}

void ViewWidget::zoomBy(double factor) {
    Cameras cameras = m_view.cameras;
    for (render::Camera& camera : cameras) {
        camera = render::zoom(camera, factor, 0.5, 0.5, 1.0);
    }
    m_moved = everyCamera;
    flyTo(cameras);
}

void ViewWidget::flyTo(const Cameras& cameras) {
    m_flightFrom = m_view.cameras;
    m_flightTo = cameras;
    m_flightClock.start();
    if (m_animated) {
        m_flight.start();
    } else {
        noteMove();
        m_view.cameras = cameras;
        update();
        emit viewChanged(m_view);
    }
}

void ViewWidget::stepFlight() {
    const double t = std::min(1.0, static_cast<double>(m_flightClock.elapsed()) / flightMs);
    for (std::size_t i = 0; i < m_view.cameras.size(); ++i) {
        m_view.cameras[i] = t < 1.0 ? render::between(m_flightFrom[i], m_flightTo[i], t) : m_flightTo[i];
    }
    if (t >= 1.0) {
        m_flight.stop();
    }
    noteMove();
    update();
    emit viewChanged(m_view);
}

}  // namespace rubble::widgets
