#include "app/gui/scenario_command.h"

#include "widgets/language.h"
#include "widgets/wording.h"

namespace rubble {

ScenarioCommand::ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, const QString& key, int gesture)
    : m_document(document), m_before(before), m_after(after), m_key(key), m_gesture(gesture) {
    name();
}

ScenarioCommand::ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, const QString& what)
    : QUndoCommand(what), m_document(document), m_before(before), m_after(after) {}

void ScenarioCommand::name() {
    const auto [row, subject] = findParameter(m_key.toStdString());
    QString label = widgets::said("parameters", row->label);
    if (!subject.empty()) {
        label += QStringLiteral(" ") + QString::fromStdString(subject);
    }
    setText(QStringLiteral("%1 %2 → %3")
                .arg(label.left(1).toLower() + label.mid(1), widgets::shownValue(parameterValue(m_before, m_key.toStdString())),
                     widgets::shownValue(parameterValue(m_after, m_key.toStdString()))));
}

void ScenarioCommand::retell() {
    if (!m_key.isEmpty()) {
        name();
    }
}

bool ScenarioCommand::mergeWith(const QUndoCommand* other) {
    const auto* next = dynamic_cast<const ScenarioCommand*>(other);
    if (next == nullptr || next->m_key != m_key || next->m_gesture != m_gesture) {
        return false;
    }
    m_after = next->m_after;
    name();
    // Dragged back to where it began: nothing to undo.
    setObsolete(m_after == m_before);
    return true;
}

}  // namespace rubble
