#include "widgets/views/view_widget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QApplication>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QRubberBand>
#include <QSurfaceFormat>
#include <algorithm>
#include <cmath>

#include "widgets/figures/draw.h"
#include "widgets/figures/palette.h"

namespace rubble::widgets {

namespace {

constexpr int restAfter = 150;  // ms
/// Pixels are taken only where less detail does not do.
constexpr double slowPixels = 5.0 / 3.0;  // of the limit for detail

double& slowestDraw() {
    static double seconds = ViewWidget::slowDraw;
    return seconds;
}

}  // namespace

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
        m_widget.context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, m_widget.defaultFramebufferObject());
        const QSize size = m_widget.devicePixels();
        render::drawWith(window, size.width(), size.height(), m_widget.m_scene.resolution());
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
    m_rest.setInterval(restAfter);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (m_simplified) {
            refresh();
        }
    });
    connect(&m_turn, &PictureTurn::due, this, qOverload<>(&ViewWidget::update));
    connect(&m_flight, &QTimer::timeout, this, &ViewWidget::stepFlight);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { emit shown(m_view.time); });
}

ViewWidget::~ViewWidget() {
    releaseGraphics();
    // The base takes the context down, when this is no view any more.
    if (context() != nullptr) {
        disconnect(context(), nullptr, this, nullptr);
    }
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
    Target target(*this);
    const bool moving = m_rest.isActive();
    m_simplified = moving && m_detail.tooSlow(slowestDraw());
    m_scene.setSimplified(m_simplified, m_resolution.share());
    figures::draw(m_view, m_scene, target);
    watchShading(clock);
    context()->functions()->glFinish();
    const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    if (m_simplified) {
        m_resolution.drew(seconds, slowPixels * slowestDraw());
        m_rest.start();  // a picture that took long is not yet rest
    } else if (moving) {
        m_detail.drewMoving(seconds);
    } else {
        m_detail.drewResting(seconds, slowestDraw());
    }
}

void ViewWidget::noteMove() {
    m_rest.start();
}

void ViewWidget::simplifyAbove(double seconds) {
    slowestDraw() = seconds;
}

QImage ViewWidget::picture() {
    m_rest.stop();
    return grabFramebuffer();
}

void ViewWidget::setData(const render::SceneData& scene) {
    if (scene.fe != m_scene.data().fe) {
        m_detail = {};
        m_resolution = {};
    }
    m_scene.setData(scene);
    refit();  // another ground, or another legend
    update();
}

void ViewWidget::setOther(const render::SceneData& scene, const std::string& scenario) {
    m_scene.setOther(scene, scenario);
    refit();
    update();
}

void ViewWidget::setView(const render::View& view) {
    if (view == m_view) {
        return;
    }
    const bool reselected = view.selection != m_view.selection;
    // A length that was begun lives here alone.
    m_measuring = m_measuring && view.measurements == m_view.measurements;
    const bool reworded = view.colourBy != m_view.colourBy || view.style != m_view.style || view.legends != m_view.legends ||
                          view.captions != m_view.captions;
    const bool rearranged = view.layout != m_view.layout || view.camerasLinked != m_view.camerasLinked;
    takeMoved(view.cameras);
    m_view = view;
    if (reworded || rearranged) {
        refit();  // another legend leaves another room, and so do other panes
    }
    update();
    if (reselected) {
        emit selectionChanged();
    }
}

void ViewWidget::setTime(double time) {
    if (time != m_view.time) {
        noteMove();
        m_view.time = time;
        update();
    }
}

const render::PaneStatus& ViewWidget::status(render::PaneContent content) const {
    return m_scene.status(content);
}

std::vector<ElementIndex> ViewWidget::elementsWhere(const std::function<bool(const Vec3&)>& inside) const {
    const bool feOnly = m_view.layout == render::Layout::FeOnly;
    return m_scene.elementsWhere(feOnly ? render::PaneContent::Fe : render::PaneContent::Fragments, inside);
}

void ViewWidget::setTool(Tool tool) {
    dropMeasurement();
    m_tool = tool;
    setCursor(tool == Tool::Select ? Qt::ArrowCursor : Qt::CrossCursor);
    setMouseTracking(tool != Tool::Select);
}

bool ViewWidget::dropMeasurement() {
    if (!m_measuring) {
        return false;
    }
    m_measuring = false;
    m_view.measurements.pop_back();
    update();
    emit measured();
    return true;
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

std::optional<ViewWidget::Hit> ViewWidget::hitAt(const QPointF& place) const {
    constexpr double nodeWithin = 10.0;  // px of the screen
    const auto cursor = cursorAt(place);
    if (!cursor) {
        return std::nullopt;
    }
    const double scale = devicePixelRatioF();
    const int x = static_cast<int>(place.x() * scale);
    const int y = static_cast<int>(place.y() * scale);
    const auto pick = m_scene.pick(x, y);
    if (!pick) {
        const auto ground = m_scene.groundAt(x, y);
        return ground ? std::optional(Hit{*ground, false, std::nullopt}) : std::nullopt;
    }
    // Seen under as many pixels at the distance of the click.
    render::Camera there = render::cameraOf(m_view, cursor->pane.content);
    const Vec3 ahead = (there.focalPoint - there.position).normalized();
    there.focalPoint = there.position + ahead * std::max(1e-3, ahead.dot(pick->position - there.position));
    const double reach = nodeWithin * scale * render::metresPerPixel(there, cursor->pane.height);
    const bool node = (pick->corner - pick->position).norm() < reach;
    return Hit{node ? pick->corner : pick->position, node, pick};
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
    m_pressed = m_grabbed = event->position();
    m_dragged = false;
    const auto cursor = cursorAt(m_grabbed);
    m_pane = cursor ? std::optional(cursor->pane) : std::nullopt;
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        stretchMeasurement(event->position());
        return;
    }
    // A hand trembles by some pixels while it clicks.
    m_dragged = m_dragged || (event->position() - m_pressed).manhattanLength() > QApplication::startDragDistance();
    if (!m_pane || !m_dragged) {
        return;
    }
    if ((event->buttons() & Qt::LeftButton) != 0 && (event->modifiers() & Qt::ControlModifier) != 0) {
        band(QRectF(m_pressed, event->position()).normalized().toRect());
        return;
    }
    const QPointF moved = event->position() - m_grabbed;
    m_grabbed = event->position();
    const std::size_t index = render::cameraIndex(m_view, m_pane->content);
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

void ViewWidget::band(const QRect& rectangle) {
    if (m_band == nullptr) {
        m_band = new QRubberBand(QRubberBand::Rectangle, this);
    }
    m_band->setGeometry(rectangle);
    m_band->show();
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
    if (m_band != nullptr && m_band->isVisible()) {
        m_band->hide();
        if (m_pane) {
            const double scale = devicePixelRatioF();
            const QRectF area = m_band->geometry();
            const auto inside =
                m_scene.elementsIn(*m_pane, static_cast<int>(area.left() * scale), static_cast<int>(area.top() * scale),
                                   static_cast<int>(area.right() * scale), static_cast<int>(area.bottom() * scale));
            std::vector<ElementIndex> all = m_view.selection;
            all.insert(all.end(), inside.begin(), inside.end());
            std::sort(all.begin(), all.end());
            all.erase(std::unique(all.begin(), all.end()), all.end());
            setSelection(std::move(all));
        }
    } else if (event->button() == Qt::LeftButton && !m_dragged) {
        click(event->position(), (event->modifiers() & Qt::ControlModifier) != 0);
    }
    m_pane.reset();
}

std::optional<Vec3> ViewWidget::pointAt(const QPointF& position) const {
    const double scale = devicePixelRatioF();
    const int x = static_cast<int>(position.x() * scale);
    const int y = static_cast<int>(position.y() * scale);
    const auto hit = m_scene.pick(x, y);
    return hit ? std::optional(hit->position) : m_scene.groundAt(x, y);
}

void ViewWidget::click(const QPointF& position, bool adds) {
    if (m_tool != Tool::Select) {
        if (const auto point = pointAt(position)) {
            measure(*point);
        }
        return;
    }
    const double scale = devicePixelRatioF();
    const auto hit = m_scene.pick(static_cast<int>(position.x() * scale), static_cast<int>(position.y() * scale));
    if (!adds) {
        setSelection(hit ? std::vector{hit->element} : std::vector<ElementIndex>());
    } else if (hit) {
        std::vector<ElementIndex> selection = m_view.selection;
        const auto there = std::find(selection.begin(), selection.end(), hit->element);
        if (there != selection.end()) {
            selection.erase(there);
        } else {
            selection.push_back(hit->element);
        }
        setSelection(std::move(selection));
    }
}

void ViewWidget::setSelection(std::vector<ElementIndex> selection) {
    if (selection != m_view.selection) {
        m_view.selection = std::move(selection);
        update();
        emit selectionChanged();
        emit viewChanged(m_view);
    }
}

void ViewWidget::measure(const Vec3& point) {
    if (m_measuring) {
        m_view.measurements.back().to = point;
    } else {
        m_view.measurements.push_back({point, point, m_tool == Tool::Height});
    }
    m_measuring = !m_measuring;
    update();
    emit measured();
    emit viewChanged(m_view);
}

void ViewWidget::stretchMeasurement(const QPointF& position) {
    if (!m_measuring) {
        return;
    }
    if (const auto point = pointAt(position)) {
        m_view.measurements.back().to = *point;
        update();
    }
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    const auto cursor = cursorAt(event->position());
    // The second press of two clicks while measuring is a click of its own.
    if (m_tool != Tool::Select) {
        mousePressEvent(event);
        return;
    }
    if (!cursor || event->button() != Qt::LeftButton) {
        return;
    }
    m_dragged = true;  // its release is no click
    if (const auto point = pointAt(event->position())) {
        Cameras cameras = m_view.cameras;
        const std::size_t index = render::cameraIndex(m_view, cursor->pane.content);
        cameras[index] = render::centreOn(cameras[index], *point);
        m_moved[index] = true;
        flyTo(cameras);
    }
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || m_tool == Tool::Select) {
        QOpenGLWidget::keyPressEvent(event);
    } else {
        leaveTool();
    }
}

void ViewWidget::leaveTool() {
    if (!dropMeasurement()) {
        setTool(Tool::Select);
        emit measured();
    }
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
    const auto cursor = cursorAt(event->position());
    if (!cursor) {
        return;
    }
    const std::size_t index = render::cameraIndex(m_view, cursor->pane.content);
    const double factor = std::pow(1.2, event->angleDelta().y() / 120.0);
    setCamera(index, render::zoom(m_view.cameras[index], factor, cursor->u, cursor->v, cursor->pane.aspect()));
    event->accept();
}

}  // namespace rubble::widgets
