#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "widgets/render/camera.h"
#include "widgets/render/scene.h"
#include "widgets/render/view.h"

namespace rubble::widgets {

/// All panes of a view as one OpenGL widget. Shows what it is given; moves the cameras by mouse and says so. Left orbits, middle or
/// Shift-left pans, the wheel zooms to the cursor, a double-click sets the centre.
class ViewWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit ViewWidget(QWidget* parent = nullptr);
    ~ViewWidget() override;

    void setData(const render::SceneData& scene);
    const render::View& view() const { return m_view; }
    void setView(const render::View& view);
    void setTime(double time);
    /// Fits the cameras of all panes to the model, keeping their directions.
    void fit();
    /// Looks from a standard direction at the whole model.
    void look(render::Preset preset);
    /// Moves the cameras so that a point [m] lies in the middle, at the distance and in the direction they have.
    void centreOn(const Vec3& point);
    /// Camera moves are animated (200 ms) unless the user asks for reduced motion.
    void setAnimated(bool animated) { m_animated = animated; }

    /// What the panes showed when they were last drawn.
    const render::PaneStatus& status(render::PaneContent content) const;
    /// Wall time of the last draw, s.
    double drawSeconds() const { return m_drawSeconds; }

signals:
    /// The user moved a camera.
    void viewChanged(const rubble::render::View& view);
    /// A frame with this view time was drawn and shown.
    void shown(double time);

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    class Target;
    struct Window;
    struct Cursor {
        render::Pane pane;
        double u, v;
    };
    std::optional<Cursor> cursorAt(const QPointF& position) const;
    QSize devicePixels() const;
    std::size_t cameraOf(render::PaneContent content) const;
    void setCamera(std::size_t index, const render::Camera& camera);
    void flyTo(const std::array<render::Camera, 2>& cameras);
    void stepFlight();
    void releaseGraphics();

    std::unique_ptr<Window> m_window;
    render::Scene m_scene;
    render::View m_view;
    bool m_ready = false;
    bool m_animated = true;
    double m_drawSeconds = 0.0;
    QPointF m_grabbed;
    std::optional<render::Pane> m_pane;
    QTimer m_flight;
    QElapsedTimer m_flightClock;
    std::array<render::Camera, 2> m_flightFrom;
    std::array<render::Camera, 2> m_flightTo;
};

}  // namespace rubble::widgets
