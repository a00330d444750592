#include "app/gui/stage/view_tools.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "app/gui/stage/view_area.h"
#include "core/fe/frame_transform.h"
#include "widgets/views/clip_bar.h"

namespace rubble {

namespace {

constexpr double turnStep = std::numbers::pi / 12.0;
constexpr double zoomStep = 1.25;

struct Look {
    ActionId id;
    render::Preset preset;
};
constexpr std::array<Look, 8> looks{{{ActionId::LookSide, render::Preset::Side},
                                     {ActionId::LookFront, render::Preset::Front},
                                     {ActionId::LookBack, render::Preset::Back},
                                     {ActionId::LookLeft, render::Preset::Left},
                                     {ActionId::LookRight, render::Preset::Right},
                                     {ActionId::LookTop, render::Preset::Top},
                                     {ActionId::LookBottom, render::Preset::Bottom},
                                     {ActionId::LookCorner, render::Preset::Corner}}};

struct Map {
    ActionId id;
    render::ColourMap map;
};
constexpr std::array<Map, 4> maps{{{ActionId::MapStandard, render::ColourMap::Standard},
                                   {ActionId::MapViridis, render::ColourMap::Viridis},
                                   {ActionId::MapCividis, render::ColourMap::Cividis},
                                   {ActionId::MapGrey, render::ColourMap::Grey}}};

constexpr std::array modelActions{ActionId::LookSide,        ActionId::LookFront,     ActionId::LookBack,    ActionId::LookLeft,
                                  ActionId::LookRight,       ActionId::LookTop,       ActionId::LookBottom,  ActionId::LookCorner,
                                  ActionId::Parallel,        ActionId::ZoomIn,        ActionId::ZoomOut,     ActionId::TurnLeft,
                                  ActionId::TurnRight,       ActionId::TurnUp,        ActionId::TurnDown,    ActionId::Clip,
                                  ActionId::MeasureDistance, ActionId::MeasureHeight, ActionId::GroundGrid,  ActionId::Axes,
                                  ActionId::Shading,         ActionId::Presentation,  ActionId::MapStandard, ActionId::MapViridis,
                                  ActionId::MapCividis,      ActionId::MapGrey,       ActionId::Shadows};

}  // namespace

ViewTools::ViewTools(Actions& actions, ViewArea& area, QObject* parent) : QObject(parent), m_actions(actions), m_area(area) {
    connectCameras();
    connectStyle();
    connectTools();
    connect(&area.views(), &widgets::ViewWidget::measured, this, &ViewTools::refresh);
    refresh();
}

void ViewTools::change(const std::function<void(render::View&)>& edit) {
    render::View view = m_area.views().view();
    edit(view);
    m_area.views().setView(view);
    refresh();
}

void ViewTools::connectCameras() {
    const auto on = [this](ActionId id, auto moves) {
        connect(&m_actions[id], &QAction::triggered, this, [this, moves](bool checked) { moves(m_area.watched(), checked); });
    };
    for (const Look& look : looks) {
        on(look.id, [preset = look.preset](widgets::ViewWidget& views, bool) { views.look(preset); });
    }
    on(ActionId::Fit, [](widgets::ViewWidget& views, bool) { views.fit(); });
    on(ActionId::Parallel, [](widgets::ViewWidget& views, bool parallel) { views.setParallel(parallel); });
    on(ActionId::ZoomIn, [](widgets::ViewWidget& views, bool) { views.zoomBy(zoomStep); });
    on(ActionId::ZoomOut, [](widgets::ViewWidget& views, bool) { views.zoomBy(1.0 / zoomStep); });
    on(ActionId::TurnLeft, [](widgets::ViewWidget& views, bool) { views.turn(-turnStep, 0.0); });
    on(ActionId::TurnRight, [](widgets::ViewWidget& views, bool) { views.turn(turnStep, 0.0); });
    on(ActionId::TurnUp, [](widgets::ViewWidget& views, bool) { views.turn(0.0, turnStep); });
    on(ActionId::TurnDown, [](widgets::ViewWidget& views, bool) { views.turn(0.0, -turnStep); });
}

void ViewTools::connectStyle() {
    const auto toggles = [this](ActionId id, bool render::View::* flag) {
        connect(&m_actions[id], &QAction::triggered, this,
                [this, flag](bool on) { change([&](render::View& view) { view.*flag = on; }); });
    };
    toggles(ActionId::GroundGrid, &render::View::groundGrid);
    toggles(ActionId::Axes, &render::View::axes);
    toggles(ActionId::Shading, &render::View::shading);
    toggles(ActionId::Shadows, &render::View::shadows);
    connect(&m_actions[ActionId::Presentation], &QAction::triggered, this, [this](bool on) {
        change([&](render::View& view) { view.style = on ? render::Style::Presentation : render::Style::Analysis; });
    });
    for (const Map& map : maps) {
        connect(&m_actions[map.id], &QAction::triggered, this,
                [this, chosen = map.map] { change([&](render::View& view) { view.colourMap = chosen; }); });
    }
}

void ViewTools::connectTools() {
    connect(&m_actions[ActionId::Clip], &QAction::triggered, this, &ViewTools::setClip);
    using Tool = widgets::ViewWidget::Tool;
    for (const auto& [id, tool] :
         {std::pair(ActionId::MeasureDistance, Tool::Distance), std::pair(ActionId::MeasureHeight, Tool::Height)}) {
        connect(&m_actions[id], &QAction::triggered, this, [this, tool = tool](bool on) {
            m_area.views().setTool(on ? tool : Tool::Select);
            m_area.views().setFocus();
            refresh();
        });
    }
    connect(&m_actions[ActionId::ClearMeasurements], &QAction::triggered, this, [this] {
        m_area.views().dropMeasurement();
        change([](render::View& view) { view.measurements.clear(); });
    });
    widgets::ClipBar& bar = m_area.clipBar();
    connect(&bar, &widgets::ClipBar::planeChanged, this,
            [this](const render::ClipPlane& plane) { change([&](render::View& view) { view.clip = plane; }); });
    connect(&bar, &widgets::ClipBar::closeRequested, this, [this] { setClip(false); });
    connect(&bar, &widgets::ClipBar::viewDirectionRequested, this, [this] {
        change([](render::View& view) {
            const render::Camera& camera = view.cameras[0];
            // The near half is cut away.
            view.clip = render::ClipPlane{camera.focalPoint, (camera.position - camera.focalPoint).normalized()};
        });
    });
}

void ViewTools::setClip(bool on) {
    change([&](render::View& view) { view.clip = on ? m_area.clipBar().plane() : std::nullopt; });
}

void ViewTools::refresh() {
    const widgets::ViewWidget& views = m_area.views();
    const render::View& view = views.view();
    const bool have = views.data().fe != nullptr;
    for (const ActionId id : modelActions) {
        m_actions.enable(id, have);
    }
    m_actions[ActionId::Parallel].setChecked(m_area.watched().view().cameras[0].parallel);
    m_actions[ActionId::GroundGrid].setChecked(view.groundGrid);
    m_actions[ActionId::Axes].setChecked(view.axes);
    m_actions[ActionId::Shading].setChecked(view.shading);
    m_actions[ActionId::Shadows].setChecked(view.shadows);
    m_actions[ActionId::Presentation].setChecked(view.style == render::Style::Presentation);
    for (const Map& map : maps) {
        m_actions[map.id].setChecked(view.colourMap == map.map);
    }
    m_actions[ActionId::Clip].setChecked(view.clip.has_value());
    m_actions[ActionId::MeasureDistance].setChecked(views.tool() == widgets::ViewWidget::Tool::Distance);
    m_actions[ActionId::MeasureHeight].setChecked(views.tool() == widgets::ViewWidget::Tool::Height);
    m_actions.enable(ActionId::ClearMeasurements, !view.measurements.empty());
    if (have) {
        m_area.clipBar().setBounds(views.bounds(), FrameTransform(views.data().fe->contents().frame).localZero());
    }
    m_area.clipBar().setVisible(view.clip.has_value());
    if (view.clip) {
        m_area.clipBar().setPlane(*view.clip);
    }
}

}  // namespace rubble
