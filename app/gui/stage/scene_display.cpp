#include "app/gui/stage/scene_display.h"

#include <QComboBox>
#include <array>
#include <utility>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "widgets/basics/theme.h"

namespace rubble {

namespace {

/// The actions of the layouts, in their order.
constexpr std::array layoutActions = {ActionId::Beside,  ActionId::Stacked, ActionId::FeOnly,       ActionId::FragmentsOnly,
                                      ActionId::Overlay, ActionId::Four,    ActionId::OtherScenario};

}  // namespace

SceneDisplay::SceneDisplay(Session& session, Playback& playback, ViewArea& area, Actions& actions, QComboBox& colours,
                           QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_playback(playback),
      m_area(area),
      m_actions(actions),
      m_colours(colours),
      m_kept(session.part<Kept>()) {
    connectActions();
    connect(&session, &Session::preferencesChanged, this, [this](const widgets::Preferences& before) {
        if (before.materials != m_session.preferences().materials) {
            render::View view = m_area.views().view();
            view.style = preferredStyle();
            setView(view);
        }
    });
    connect(&m_computation, &Computation::runGrew, &m_area.views(), &widgets::ViewWidget::refresh);
    connect(&m_computation, &Computation::progressed, this,
            [this](const QString& what) { m_area.setActivity(what.isEmpty() ? QString() : what + QStringLiteral(" …")); });
}

SceneDisplay::~SceneDisplay() {
    m_kept.view = m_area.views().view();
    m_kept.moved = m_area.views().moved();
}

void SceneDisplay::connectActions() {
    for (std::size_t i = 0; i < layoutActions.size(); ++i) {
        connect(&m_actions[layoutActions[i]], &QAction::triggered, this,
                [this, layout = static_cast<render::Layout>(i)] { setLayout(layout); });
    }
    connect(&m_actions[ActionId::Link], &QAction::triggered, this, [this](bool linked) {
        render::View view = m_area.views().view();
        // Unlinked, the fragments start from where both looked; linked, both look as the FE view does.
        view.cameras[1] = view.cameras[2] = view.cameras[0];
        view.camerasLinked = linked;
        setView(view);
    });
    connect(&m_colours, &QComboBox::activated, this, [this] {
        render::View view = m_area.views().view();
        view.colourBy = static_cast<render::ColourBy>(m_colours.currentData().toInt());
        setView(view);
    });
}

render::SceneData SceneDisplay::data() const {
    const RunRecord* record = m_computation.currentRun();
    const Results& from = record != nullptr ? record->results : m_computation.results();
    render::SceneData scene;
    scene.fe = m_computation.inputs().fe;
    scene.components = from.components;
    scene.fragments = from.fragments;
    scene.clustering = from.clustering;
    scene.trajectory = record != nullptr ? record->reader : nullptr;
    scene.reference = m_reference;
    scene.loose = m_looseOf.lock() == scene.fe ? m_loose : nullptr;
    scene.setSurroundings(record != nullptr ? record->scenario : m_document.scenario(), m_computation.inputs().terrain,
                          record != nullptr ? record->outcome.get() : nullptr);
    scene.orthophoto = m_ground != nullptr ? m_ground : m_computation.terrain().orthophoto;
    scene.surroundings = m_computation.terrain().surroundings;
    scene.points = m_points;
    return scene;
}

void SceneDisplay::show() {
    const render::SceneData scene = data();
    if (!(scene == m_shown)) {
        m_shown = scene;
        m_area.views().setData(scene);
        emit changed();
    }
}

void SceneDisplay::goOn() {
    show();
    m_area.showViews(m_computation.inputs().fe != nullptr, !m_document.empty());
    render::View first = m_area.views().view();
    first.style = preferredStyle();
    render::View view = m_kept.view.value_or(first);
    view.theme = widgets::currentTheme();
    setView(view);
    if (m_kept.view) {
        m_area.views().setMoved(m_kept.moved);
    }
}

void SceneDisplay::setView(const render::View& view) {
    m_area.views().setView(view);
    m_actions[layoutActions[static_cast<std::size_t>(view.layout)]].setChecked(true);
    m_actions[ActionId::Link].setChecked(view.camerasLinked);
    m_colours.setCurrentIndex(m_colours.findData(static_cast<int>(view.colourBy)));
    emit viewSet(view);
}

render::Style SceneDisplay::style() const {
    return m_area.views().view().style;
}

void SceneDisplay::setLayout(render::Layout layout) {
    render::View view = m_area.views().view();
    view.layout = layout;
    setView(view);
}

void SceneDisplay::look(render::View view) {
    view.theme = widgets::currentTheme();
    m_playback.clock().pause();
    setView(view);
    m_playback.scrub(view.time);
    emit changed();
}

void SceneDisplay::lookAtAll() {
    const render::View before = m_area.views().view();
    render::View view = render::defaultView(m_shown, m_area.views().width(), m_area.views().height());
    view.theme = widgets::currentTheme();
    view.colourBy = before.colourBy;
    view.colourMap = before.colourMap;
    view.style = before.style;
    view.axes = before.axes;
    view.cloud = before.cloud;
    view.pointColour = before.pointColour;
    view.groundGrid = before.groundGrid;
    view.shading = before.shading;
    view.shadows = before.shadows;
    setView(view);
    m_area.views().keepFitted();
    emit changed();
}

void SceneDisplay::setReference(std::shared_ptr<const TrajectoryReader> reference) {
    m_reference = std::move(reference);
    show();
}

void SceneDisplay::setLoose(std::shared_ptr<const LooseStructure> loose) {
    m_loose = std::move(loose);
    m_looseOf = m_computation.inputs().fe;
    show();
}

void SceneDisplay::setGround(std::shared_ptr<const Orthophoto> ground) {
    m_ground = std::move(ground);
    show();
}

void SceneDisplay::setPoints(std::shared_ptr<const render::SitePoints> points) {
    // Not told as a change: nothing but the picture depends on them.
    m_points = std::move(points);
    if (m_shown.points != m_points) {
        m_shown.points = m_points;
        m_area.views().setData(m_shown);
    }
}

render::Style SceneDisplay::preferredStyle() const {
    return m_session.preferences().materials ? render::Style::Presentation : render::Style::Analysis;
}

void SceneDisplay::useTheme() {
    render::View view = m_area.views().view();
    view.theme = widgets::currentTheme();
    m_area.views().setView(view);
}

}  // namespace rubble
