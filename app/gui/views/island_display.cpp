#include "app/gui/views/island_display.h"

#include "app/gui/session/session.h"

namespace rubble {

bool IslandDisplay::Scene::operator==(const Scene& other) const {
    return fe.lock() == other.fe.lock() && terrain.lock() == other.terrain.lock() && revival == other.revival &&
           level == other.level && levelHeight == other.levelHeight;
}

IslandDisplay::IslandDisplay(Session& session, QObject* parent)
    : QObject(parent), m_document(session.document()), m_computation(session.computation()), m_kept(session.part<Kept>()) {
    connect(&m_computation, &Computation::prepared, this, &IslandDisplay::refresh);
    connect(&m_document, &Document::scenarioChanged, this, &IslandDisplay::refresh);
}

std::shared_ptr<const LooseStructure> IslandDisplay::loose() const {
    return looseOf(m_document.scenario());
}

std::shared_ptr<const LooseStructure> IslandDisplay::looseOf(const Scenario& scenario) const {
    return m_shown && m_computation.inputs().fe != nullptr && m_kept.scene == sceneOf(scenario) ? m_kept.loose : nullptr;
}

void IslandDisplay::setShown(bool shown) {
    if (shown != m_shown) {
        m_shown = shown;
        refresh();
        emit changed();
    }
}

IslandDisplay::Scene IslandDisplay::sceneOf(const Scenario& scenario) const {
    const Inputs& inputs = m_computation.inputs();
    const SiteSurface ground = groundBeforeRun(inputs, scenario);
    return {inputs.fe, ground.terrain, scenario.fragments.revival, ground.level, ground.levelHeight};
}

void IslandDisplay::refresh() {
    const Scene scene = sceneOf(m_document.scenario());
    if (!m_shown || m_computation.inputs().fe == nullptr ||
        (m_kept.scene == scene && (m_kept.loose != nullptr || m_worker.busy()))) {
        return;
    }
    m_kept = {scene, nullptr};
    emit changed();
    auto made = std::make_shared<std::shared_ptr<const LooseStructure>>();
    m_worker.start({Worker::Kind::Study,
                    [inputs = m_computation.inputs(), scenario = m_document.scenario(), made](const Execution& execution) {
                        *made = std::make_shared<const LooseStructure>(looseScene(inputs, scenario, execution));
                    },
                    [this, scene, made](const std::exception_ptr&) {
                        if (*made != nullptr && scene == m_kept.scene) {
                            m_kept.loose = *made;
                            emit changed();
                        }
                    }});
}

}  // namespace rubble
