#include "widgets/view_widget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <cmath>

#include "widgets/figures/draw.h"
#include "widgets/figures/palette.h"

namespace rubble::widgets {

struct ViewWidget::Window {
    vtkNew<vtkGenericOpenGLRenderWindow> gl;
};

/// Brings the scene's picture onto the widget, then lends the widget as paint device for captions.
class ViewWidget::Target : public figures::Surface {
public:
    explicit Target(ViewWidget& widget) : m_widget(widget) {}

    QSize pixels() const override { return m_widget.devicePixels(); }
    double textHeight() const override { return 13.0 * m_widget.devicePixelRatioF(); }
    QPaintDevice& drawScene() override {
        vtkGenericOpenGLRenderWindow& window = *m_widget.m_window->gl;
        // Qt has left GL in a state that VTK does not know of.
        vtkOpenGLState* state = window.GetState();
        state->Reset();
        state->Push();
        window.SetFrameBlitModeToBlitToCurrent();
        m_widget.context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, m_widget.defaultFramebufferObject());
        window.Render();
        state->Pop();
        readyForPainter();
        return m_widget;
    }

private:
    /// Qt's painter takes GL as it finds it, and VTK leaves depth test, culling and scissor on.
    void readyForPainter() {
        QOpenGLFunctions& gl = *m_widget.context()->functions();
        gl.glBindFramebuffer(GL_FRAMEBUFFER, m_widget.defaultFramebufferObject());
        gl.glUseProgram(0);
        gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
        gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        gl.glActiveTexture(GL_TEXTURE0);
        gl.glDisable(GL_DEPTH_TEST);
        gl.glDisable(GL_CULL_FACE);
        gl.glDisable(GL_SCISSOR_TEST);
        gl.glDisable(GL_STENCIL_TEST);
        gl.glDepthMask(GL_TRUE);
        gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        const QSize size = m_widget.devicePixels();
        gl.glViewport(0, 0, size.width(), size.height());
    }

    ViewWidget& m_widget;
};

ViewWidget::ViewWidget(QWidget* parent) : QOpenGLWidget(parent), m_window(std::make_unique<Window>()) {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    format.setSwapInterval(0);
    setFormat(format);
    setMinimumSize(240, 160);
    setFocusPolicy(Qt::ClickFocus);
    setAccessibleName(tr("Views of the collapse"));
    m_window->gl->SetOwnContext(false);
    m_window->gl->SetMultiSamples(0);
    m_window->gl->SetReadyForRendering(false);
    m_flight.setInterval(12);
    connect(&m_flight, &QTimer::timeout, this, &ViewWidget::stepFlight);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { emit shown(m_view.time); });
}

ViewWidget::~ViewWidget() {
    releaseGraphics();
}

void ViewWidget::releaseGraphics() {
    if (!m_ready) {
        return;
    }
    makeCurrent();
    m_scene.detach();
    m_window->gl->Finalize();
    m_ready = false;
    doneCurrent();
}

void ViewWidget::initializeGL() {
    // The context dies when the widget moves to another window: what VTK holds in it must go first.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewWidget::releaseGraphics, Qt::UniqueConnection);
    m_window->gl->SetReadyForRendering(true);
    m_window->gl->SetIsCurrent(true);
    m_window->gl->OpenGLInit();
    m_scene.attach(*m_window->gl);
    m_ready = true;
}

QSize ViewWidget::devicePixels() const {
    const double scale = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * scale))),
            std::max(1, static_cast<int>(std::lround(height() * scale)))};
}

void ViewWidget::paintGL() {
    QElapsedTimer clock;
    clock.start();
    const QSize size = devicePixels();
    m_window->gl->SetSize(size.width(), size.height());
    Target target(*this);
    figures::draw(m_view, m_scene, target);
    m_drawSeconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
}

void ViewWidget::setData(const render::SceneData& scene) {
    m_scene.setData(scene);
    update();
}

void ViewWidget::setView(const render::View& view) {
    if (!(view == m_view)) {
        m_view = view;
        update();
    }
}

void ViewWidget::setTime(double time) {
    if (time != m_view.time) {
        m_view.time = time;
        update();
    }
}

const render::PaneStatus& ViewWidget::status(render::PaneContent content) const {
    return m_scene.status(content);
}

std::size_t ViewWidget::cameraOf(render::PaneContent content) const {
    return m_view.camerasLinked || content == render::PaneContent::Fe ? 0 : 1;
}

void ViewWidget::setCamera(std::size_t index, const render::Camera& camera) {
    m_flight.stop();
    m_view.cameras[index] = camera;
    update();
    emit viewChanged(m_view);
}

void ViewWidget::fit() {
    const QSize size = devicePixels();
    std::array<render::Camera, 2> cameras = m_view.cameras;
    for (const render::Pane& pane : render::panesOf(m_view.layout, size.width(), size.height())) {
        const std::size_t index = cameraOf(pane.content);
        cameras[index] = render::refit(m_view.cameras[index], m_scene.bounds(), pane.aspect());
    }
    flyTo(cameras);
}

void ViewWidget::look(render::Preset preset) {
    const QSize size = devicePixels();
    std::array<render::Camera, 2> cameras = m_view.cameras;
    for (const render::Pane& pane : render::panesOf(m_view.layout, size.width(), size.height())) {
        cameras[cameraOf(pane.content)] = render::fitCamera(m_scene.bounds(), pane.aspect(), preset);
    }
    flyTo(cameras);
}

void ViewWidget::centreOn(const Vec3& point) {
    std::array<render::Camera, 2> cameras = m_view.cameras;
    for (render::Camera& camera : cameras) {
        camera = render::centreOn(camera, point);
    }
    flyTo(cameras);
}

void ViewWidget::flyTo(const std::array<render::Camera, 2>& cameras) {
    m_flightFrom = m_view.cameras;
    m_flightTo = cameras;
    m_flightClock.start();
    if (m_animated) {
        m_flight.start();
    } else {
        m_view.cameras = cameras;
        update();
        emit viewChanged(m_view);
    }
}

void ViewWidget::stepFlight() {
    const double t = std::min(1.0, static_cast<double>(m_flightClock.elapsed()) / 200.0);
    for (std::size_t i = 0; i < 2; ++i) {
        m_view.cameras[i] = t < 1.0 ? render::between(m_flightFrom[i], m_flightTo[i], t) : m_flightTo[i];
    }
    if (t >= 1.0) {
        m_flight.stop();
    }
    update();
    emit viewChanged(m_view);
}

std::optional<ViewWidget::Cursor> ViewWidget::cursorAt(const QPointF& position) const {
    const double scale = devicePixelRatioF();
    const QSize size = devicePixels();
    const double x = position.x() * scale;
    const double y = position.y() * scale;
    const auto pane = render::paneAt(m_view.layout, size.width(), size.height(), static_cast<int>(x), static_cast<int>(y));
    if (!pane) {
        return std::nullopt;
    }
    return Cursor{*pane, (x - pane->x) / std::max(1, pane->width), (y - pane->y) / std::max(1, pane->height)};
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
    m_grabbed = event->position();
    const auto cursor = cursorAt(m_grabbed);
    m_pane = cursor ? std::optional(cursor->pane) : std::nullopt;
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
    if (!m_pane) {
        return;
    }
    const QPointF moved = event->position() - m_grabbed;
    m_grabbed = event->position();
    const std::size_t index = cameraOf(m_pane->content);
    const render::Camera& camera = m_view.cameras[index];
    const double scale = devicePixelRatioF();
    const bool left = (event->buttons() & Qt::LeftButton) != 0;
    if ((event->buttons() & Qt::MiddleButton) != 0 || (left && (event->modifiers() & Qt::ShiftModifier) != 0)) {
        setCamera(index, render::pan(camera, moved.x() * scale, moved.y() * scale, m_pane->height));
    } else if (left) {
        // Half a turn across the pane, whatever its size.
        const double perPixel = M_PI * scale / std::max(1, m_pane->height);
        setCamera(index, render::orbit(camera, -moved.x() * perPixel, -moved.y() * perPixel));
    }
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    const auto cursor = cursorAt(event->position());
    if (!cursor || event->button() != Qt::LeftButton) {
        return;
    }
    const double scale = devicePixelRatioF();
    const int x = static_cast<int>(event->position().x() * scale);
    const int y = static_cast<int>(event->position().y() * scale);
    const auto hit = m_scene.pick(x, y);
    const auto point = hit ? std::optional(hit->position) : m_scene.groundAt(x, y);
    if (point) {
        std::array<render::Camera, 2> cameras = m_view.cameras;
        const std::size_t index = cameraOf(cursor->pane.content);
        cameras[index] = render::centreOn(cameras[index], *point);
        flyTo(cameras);
    }
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
    const auto cursor = cursorAt(event->position());
    if (!cursor) {
        return;
    }
    const std::size_t index = cameraOf(cursor->pane.content);
    const double factor = std::pow(1.2, event->angleDelta().y() / 120.0);
    setCamera(index, render::zoom(m_view.cameras[index], factor, cursor->u, cursor->v, cursor->pane.aspect()));
    event->accept();
}

}  // namespace rubble::widgets
