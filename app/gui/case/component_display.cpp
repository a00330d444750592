#include "app/gui/case/component_display.h"

#include <QEvent>
#include <algorithm>

#include "app/gui/session/computation.h"
#include "app/gui/session/document.h"
#include "widgets/basics/theme.h"
#include "widgets/case/component_tree.h"
#include "widgets/render/basics/colour_choice.h"
#include "widgets/views/playback_clock.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

std::size_t stateAt(const FeResult& fe, double time) {
    const auto& times = fe.times();
    const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9 * std::max(1.0, std::abs(time)));
    return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

QColor colourOf(const render::Rgb& c) {
    return {c.r, c.g, c.b};
}

}  // namespace

ComponentDisplay::ComponentDisplay(Document& document, Computation& computation, widgets::PlaybackClock& clock,
                                   widgets::ViewWidget& views, widgets::ComponentTree& tree, QObject* parent)
    : QObject(parent), m_document(document), m_computation(computation), m_clock(clock), m_views(views), m_tree(tree) {
    connect(&tree, &widgets::ComponentTree::hiddenChanged, this, &ComponentDisplay::setHidden);
    connect(&tree, &widgets::ComponentTree::isolateRequested, this, &ComponentDisplay::isolate);
    connect(&tree, &widgets::ComponentTree::showAllRequested, this, &ComponentDisplay::showAll);
    connect(&tree, &widgets::ComponentTree::selectRequested, this, &ComponentDisplay::select);
    connect(&tree, &widgets::ComponentTree::colourChosen, this, &ComponentDisplay::setColour);
    connect(&tree, &widgets::ComponentTree::edited, this,
            [this](const QString& key, const ParameterValue& value) { m_document.setParameter(key, value); });
    connect(&clock, &widgets::PlaybackClock::timeChanged, this, &ComponentDisplay::showCounts);
    connect(&computation, &Computation::prepared, this, &ComponentDisplay::refresh);
    connect(&document, &Document::scenarioChanged, this, &ComponentDisplay::refresh);
    connect(&document, &Document::replaced, this, &ComponentDisplay::refresh);
    // Nothing is counted for a list that nobody sees.
    tree.installEventFilter(this);
}

bool ComponentDisplay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_tree && event->type() == QEvent::Show) {
        showCounts();
    }
    return QObject::eventFilter(watched, event);
}

void ComponentDisplay::refresh() {
    const auto& components = m_views.data().components;
    const render::View& view = m_views.view();
    std::vector<widgets::ComponentTree::Row> rows;
    if (components != nullptr && !m_document.empty()) {
        const render::SceneColours colours = figures::sceneColours(view.theme);
        for (std::size_t c = 0; c < components->list.size(); ++c) {
            const Component& component = components->list[c];
            const auto chosen = view.componentColours.find(component.name);
            const bool own = chosen != view.componentColours.end();
            rows.push_back({component.name, component.kind, std::string(materialName(component.material)),
                            colourOf(own ? chosen->second : render::colour_choice::category(colours, c)), own,
                            someMaterialFits(component.density)});
        }
    }
    m_tree.setScenario(m_document.scenario());
    m_tree.setRows(rows);
    m_tree.setEditable(!rows.empty());
    m_tree.setHidden(view.hiddenComponents);
    showCounts();
}

void ComponentDisplay::showCounts() {
    const auto& data = m_views.data();
    if (data.fe == nullptr || data.components == nullptr || !m_tree.isVisible() ||
        data.components->of.size() != data.fe->mesh().elementCount()) {
        return;
    }
    const std::size_t state = stateAt(*data.fe, m_clock.time());
    std::vector<widgets::ComponentTree::Count> counts;
    for (const Component& component : data.components->list) {
        widgets::ComponentTree::Count count;
        for (const ElementIndex element : component.elements) {
            ++(data.fe->activity().active(state, element) ? count.alive : count.dead);
        }
        counts.push_back(count);
    }
    m_tree.setCounts(counts);
}

void ComponentDisplay::setHidden(const std::vector<std::string>& names) {
    render::View view = m_views.view();
    view.hiddenComponents = names;
    m_views.setView(view);
    m_tree.setHidden(names);
}

void ComponentDisplay::isolate(const std::vector<std::string>& names) {
    const auto& components = m_views.data().components;
    std::vector<std::string> hidden;
    for (std::size_t c = 0; components != nullptr && !names.empty() && c < components->list.size(); ++c) {
        if (std::find(names.begin(), names.end(), components->list[c].name) == names.end()) {
            hidden.push_back(components->list[c].name);
        }
    }
    setHidden(hidden);
}

void ComponentDisplay::showAll() {
    render::View view = m_views.view();
    view.hidden.clear();
    m_views.setView(view);
    setHidden({});
}

void ComponentDisplay::select(const std::vector<std::string>& names) {
    const auto& components = m_views.data().components;
    std::vector<ElementIndex> elements;
    for (std::size_t c = 0; components != nullptr && c < components->list.size(); ++c) {
        const Component& component = components->list[c];
        if (std::find(names.begin(), names.end(), component.name) != names.end()) {
            elements.insert(elements.end(), component.elements.begin(), component.elements.end());
        }
    }
    std::sort(elements.begin(), elements.end());
    render::View view = m_views.view();
    view.selection = std::move(elements);
    m_views.setView(view);
}

void ComponentDisplay::setColour(const QString& name, const QColor& colour) {
    render::View view = m_views.view();
    if (colour.isValid()) {
        view.componentColours[name.toStdString()] = {static_cast<std::uint8_t>(colour.red()),
                                                     static_cast<std::uint8_t>(colour.green()),
                                                     static_cast<std::uint8_t>(colour.blue())};
    } else {
        view.componentColours.erase(name.toStdString());
    }
    m_views.setView(view);
    refresh();
}

}  // namespace rubble
