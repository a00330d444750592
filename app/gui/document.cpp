#include "app/gui/document.h"

#include "app/gui/inputs_command.h"
#include "app/gui/scenario_command.h"
#include "widgets/wording.h"

namespace rubble {

Document::Document(QObject* parent) : QObject(parent) {
    m_undo.setUndoLimit(500);
    connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

const CaseScenario* Document::active() const {
    for (const CaseScenario& each : m_case.scenarios) {
        if (each.id == m_case.activeScenario) {
            return &each;
        }
    }
    return m_case.scenarios.empty() ? nullptr : &m_case.scenarios.front();
}

const Scenario& Document::scenario() const {
    static const Scenario none;
    const CaseScenario* found = active();
    return found != nullptr ? found->scenario : none;
}

void Document::replace(Case theCase, const QString& path, const QString& base) {
    m_case = std::move(theCase);
    m_path = path;
    m_base = base;
    m_undo.clear();
    emit replaced();
    emit titleChanged();
}

void Document::close() {
    replace(Case(), {}, {});
}

void Document::saved(Case asSaved, const QString& path) {
    m_case = std::move(asSaved);
    m_path = path;
    m_base = path;
    m_undo.setClean();
    emit titleChanged();
}

void Document::put(const Scenario& scenario) {
    if (const CaseScenario* found = active()) {
        m_case.scenarios[static_cast<std::size_t>(found - m_case.scenarios.data())].scenario = scenario;
        emit scenarioChanged();
    }
}

void Document::setParameter(const QString& key, const ParameterValue& value) {
    Scenario after = scenario();
    rubble::setParameter(after, key.toStdString(), value);
    if (empty() || after == scenario()) {
        return;
    }
    m_undo.push(new ScenarioCommand(*this, scenario(), after, key, m_inGesture ? m_gesture : -1));
}

void Document::edit(const QString& what, const Scenario& after) {
    if (!empty() && !(after == scenario())) {
        m_undo.push(new ScenarioCommand(*this, scenario(), after, what));
    }
}

void Document::setInputs(std::vector<CaseInput> inputs, const QString& what) {
    if (!empty() && !(inputs == m_case.inputs)) {
        m_undo.push(new InputsCommand(*this, std::move(inputs), what));
    }
}

void Document::putInputs(const std::vector<CaseInput>& inputs) {
    m_case.inputs = inputs;
    emit inputsChanged();
}

void Document::applyPreset(const QString& name) {
    Scenario after = scenario();
    rubble::applyPreset(after, name.toStdString());
    edit(tr("preset %1").arg(name), after);
}

void Document::beginGesture() {
    ++m_gesture;
    m_inGesture = true;
}

void Document::endGesture() {
    m_inGesture = false;
}

}  // namespace rubble
