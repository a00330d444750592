#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/drawn_resolution.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/panes.h"
#include "widgets/render/scene.h"
#include "widgets/views/moving_detail.h"
#include "widgets/views/picture_turn.h"

class QRubberBand;

namespace rubble::widgets {

/// All panes of a view as one OpenGL widget. Shows what it is given; moves the cameras and selects by mouse and says so. Left
/// orbits, middle or Shift-left pans, the wheel zooms to the cursor, a double-click sets the centre, a click selects, Ctrl-click
/// adds or takes away, dragging with Ctrl adds what lies in a rectangle.
class ViewWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    /// What a click does.
    enum class Tool : std::uint8_t { Select, Distance, Height };

    explicit ViewWidget(QWidget* parent = nullptr);
    ~ViewWidget() override;

    void setData(const render::SceneData& scene);
    const render::SceneData& data() const { return m_scene.data(); }
    /// As Scene::setOther().
    void setOther(const render::SceneData& scene, const std::string& scenario);
    const render::SceneData& other() const { return m_scene.dataOf(render::PaneContent::Other); }
    /// As Scene::bounds().
    Aabb bounds() const { return m_scene.bounds(); }
    const render::View& view() const { return m_view; }
    void setView(const render::View& view);
    void setTime(double time);
    /// What is shown may look different by now, though nobody did anything: draws once no input waits.
    void refresh() { m_turn.ask(); }
    /// Fits the cameras of all panes to the model, keeping their directions. From then on they are fitted anew, at once, wherever
    /// their panes change their shape, until somebody moves them.
    void fit();
    /// The same at once, without a flight.
    void keepFitted();
    /// Which cameras somebody has moved or set: these are never fitted of themselves.
    using Moved = std::array<bool, render::paneCameras>;
    const Moved& moved() const { return m_moved; }
    /// Fits those that nobody has moved.
    void setMoved(const Moved& moved);
    /// Looks from a standard direction at the whole model.
    void look(render::Preset preset);
    /// Moves the cameras so that a point [m] lies in the middle, at the distance and in the direction they have.
    void centreOn(const Vec3& point);
    /// The same at once: for following what moves.
    void centreNow(const Vec3& point);
    /// Perspective or parallel projection in all panes but the plan; what lies in the middle keeps its size.
    void setParallel(bool parallel);
    /// Turns the cameras about their centres, rad.
    void turn(double yaw, double pitch);
    /// Nears (factor > 1) to the middle of every pane.
    void zoomBy(double factor);
    /// Measuring takes two clicks a length; a length that was begun is dropped when the tool changes.
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// Drops a length that was begun; false if none was.
    bool dropMeasurement();
    /// Takes back a length that was begun, else the tool.
    void leaveTool();
    /// Camera moves are animated (200 ms) unless the user asks for reduced motion.
    void setAnimated(bool animated) { m_animated = animated; }
    /// While time or camera move, all such widgets draw large models with less detail after two pictures in a row that took longer
    /// than this, s, and with fewer pixels if that is not enough; full detail comes back as soon as they rest. Infinite: always
    /// full detail.
    static void simplifyAbove(double seconds);
    static constexpr double slowDraw = 1.0 / 50.0;
    /// Shaded edges switch themselves off in all such widgets after two pictures in a row that took longer than this with them, s.
    static void shadeUpTo(double seconds);
    static constexpr double slowShading = 0.5;
    /// The last picture was asked for with less detail; PaneStatus::simplifiedTo says where it has less.
    bool simplified() const { return m_simplified; }
    /// What the widget shows, with full detail even on the move.
    QImage picture();

    /// The point of the model or the ground under a place in this widget, drawn onto a node of the model if one is near.
    struct Hit {
        Vec3 point = Vec3::Zero();  ///< m
        bool node = false;
        std::optional<render::Pick> pick;  ///< unset: the ground
    };
    std::optional<Hit> hitAt(const QPointF& place) const;

    /// What the panes showed when they were last drawn.
    const render::PaneStatus& status(render::PaneContent content) const;
    /// As Scene::elementsWhere(), in the pane with fragments where there is one.
    std::vector<ElementIndex> elementsWhere(const std::function<bool(const Vec3&)>& inside) const;

signals:
    /// The user moved a camera.
    void viewChanged(const rubble::render::View& view);
    /// Shaded edges were switched off, since a picture took so long [s].
    void shadingEnded(double seconds);
    /// What is selected has become something else, by mouse or by setView().
    void selectionChanged();
    /// A length was measured, or begun, or dropped.
    void measured();
    /// A frame with this view time was drawn and shown.
    void shown(double time);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void watchShading(const QElapsedTimer& clock);

    class Target;
    struct Window;
    struct Cursor {
        render::Pane pane;
        double u, v;
    };
    std::optional<Cursor> cursorAt(const QPointF& position) const;
    QSize devicePixels() const;
    std::optional<Vec3> pointAt(const QPointF& position) const;
    void click(const QPointF& position, bool adds);
    void measure(const Vec3& point);
    void stretchMeasurement(const QPointF& position);
    void band(const QRect& rectangle);
    void setSelection(std::vector<ElementIndex> selection);
    void setCamera(std::size_t index, const render::Camera& camera);
    using Cameras = std::array<render::Camera, render::paneCameras>;
    static constexpr Moved everyCamera{true, true, true, true};
    void flyTo(const Cameras& cameras);
    double heightShare(const render::Pane& pane) const;
    Cameras fitted(const Cameras& from) const;
    void refit();
    void takeMoved(const Cameras& cameras);
    void stepFlight();
    void releaseGraphics();
    void noteMove();

    std::unique_ptr<Window> m_window;
    render::Scene m_scene;
    render::View m_view;
    bool m_ready = false;
    bool m_animated = true;
    bool m_simplified = false;
    int m_slowShaded = 0;  ///< pictures in a row that took too long with shaded edges
    MovingDetail m_detail;
    render::DrawnResolution m_resolution;  ///< while simplified
    PictureTurn m_turn;
    QTimer m_rest;  ///< runs from the last move until the views count as resting
    QPointF m_pressed;
    QPointF m_grabbed;
    bool m_dragged = false;
    Tool m_tool = Tool::Select;
    bool m_measuring = false;  ///< the last measurement of the view has one end yet
    QRubberBand* m_band = nullptr;
    std::optional<render::Pane> m_pane;
    QTimer m_flight;
    QElapsedTimer m_flightClock;
    Moved m_moved = everyCamera;
    Cameras m_flightFrom;
    Cameras m_flightTo;
};

}  // namespace rubble::widgets
