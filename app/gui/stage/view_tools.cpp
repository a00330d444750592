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
    const char* id;
    render::Preset preset;
};
constexpr std::array<Look, 8> looks{{{"look_side", render::Preset::Side},
                                     {"look_front", render::Preset::Front},
                                     {"look_back", render::Preset::Back},
                                     {"look_left", render::Preset::Left},
                                     {"look_right", render::Preset::Right},
                                     {"look_top", render::Preset::Top},
                                     {"look_bottom", render::Preset::Bottom},
                                     {"look_corner", render::Preset::Corner}}};

struct Map {
    const char* id;
    render::ColourMap map;
};
constexpr std::array<Map, 4> maps{{{"map_standard", render::ColourMap::Standard},
                                   {"map_viridis", render::ColourMap::Viridis},
                                   {"map_cividis", render::ColourMap::Cividis},
                                   {"map_grey", render::ColourMap::Grey}}};

constexpr std::array modelActions{"look_side",   "look_front",  "look_back", "look_left",    "look_right",       "look_top",
                                  "look_bottom", "look_corner", "parallel",  "zoom_in",      "zoom_out",         "turn_left",
                                  "turn_right",  "turn_up",     "turn_down", "clip",         "measure_distance", "measure_height",
                                  "ground_grid", "axes",        "shading",   "presentation", "map_standard",     "map_viridis",
                                  "map_cividis", "map_grey"};

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
    widgets::ViewWidget& views = m_area.views();
    for (const Look& look : looks) {
        connect(&m_actions[look.id], &QAction::triggered, this, [&views, preset = look.preset] { views.look(preset); });
    }
    connect(&m_actions["parallel"], &QAction::triggered, this, [&views](bool on) { views.setParallel(on); });
    connect(&m_actions["zoom_in"], &QAction::triggered, this, [&views] { views.zoomBy(zoomStep); });
    connect(&m_actions["zoom_out"], &QAction::triggered, this, [&views] { views.zoomBy(1.0 / zoomStep); });
    connect(&m_actions["turn_left"], &QAction::triggered, this, [&views] { views.turn(-turnStep, 0.0); });
    connect(&m_actions["turn_right"], &QAction::triggered, this, [&views] { views.turn(turnStep, 0.0); });
    connect(&m_actions["turn_up"], &QAction::triggered, this, [&views] { views.turn(0.0, turnStep); });
    connect(&m_actions["turn_down"], &QAction::triggered, this, [&views] { views.turn(0.0, -turnStep); });
}

void ViewTools::connectStyle() {
    const auto toggles = [this](const char* id, bool render::View::* flag) {
        connect(&m_actions[id], &QAction::triggered, this,
                [this, flag](bool on) { change([&](render::View& view) { view.*flag = on; }); });
    };
    toggles("ground_grid", &render::View::groundGrid);
    toggles("axes", &render::View::axes);
    toggles("shading", &render::View::shading);
    connect(&m_actions["presentation"], &QAction::triggered, this, [this](bool on) {
        change([&](render::View& view) { view.style = on ? render::Style::Presentation : render::Style::Analysis; });
    });
    for (const Map& map : maps) {
        connect(&m_actions[map.id], &QAction::triggered, this,
                [this, chosen = map.map] { change([&](render::View& view) { view.colourMap = chosen; }); });
    }
}

void ViewTools::connectTools() {
    connect(&m_actions["clip"], &QAction::triggered, this, &ViewTools::setClip);
    using Tool = widgets::ViewWidget::Tool;
    for (const auto& [id, tool] : {std::pair("measure_distance", Tool::Distance), std::pair("measure_height", Tool::Height)}) {
        connect(&m_actions[id], &QAction::triggered, this, [this, tool = tool](bool on) {
            m_area.views().setTool(on ? tool : Tool::Select);
            m_area.views().setFocus();
            refresh();
        });
    }
    connect(&m_actions["clear_measurements"], &QAction::triggered, this, [this] {
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
    for (const char* id : modelActions) {
        m_actions[id].setEnabled(have);
    }
    m_actions["parallel"].setChecked(view.cameras[0].parallel);
    m_actions["ground_grid"].setChecked(view.groundGrid);
    m_actions["axes"].setChecked(view.axes);
    m_actions["shading"].setChecked(view.shading);
    m_actions["presentation"].setChecked(view.style == render::Style::Presentation);
    for (const Map& map : maps) {
        m_actions[map.id].setChecked(view.colourMap == map.map);
    }
    m_actions["clip"].setChecked(view.clip.has_value());
    m_actions["measure_distance"].setChecked(views.tool() == widgets::ViewWidget::Tool::Distance);
    m_actions["measure_height"].setChecked(views.tool() == widgets::ViewWidget::Tool::Height);
    m_actions["clear_measurements"].setEnabled(!view.measurements.empty());
    if (have) {
        m_area.clipBar().setBounds(views.bounds(), FrameTransform(views.data().fe->contents().frame).localZero());
    }
    m_area.clipBar().setVisible(view.clip.has_value());
    if (view.clip) {
        m_area.clipBar().setPlane(*view.clip);
    }
}

}  // namespace rubble
