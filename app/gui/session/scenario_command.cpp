#include "app/gui/session/scenario_command.h"

#include <utility>

#include "widgets/basics/language.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

widgets::Wording nameOf(const Scenario& before, const Scenario& after, const QString& key) {
    return [key, from = parameterValue(before, key.toStdString()), to = parameterValue(after, key.toStdString())] {
        const auto [row, subject] = findParameter(key.toStdString());
        QString label = widgets::said("parameters", row->label);
        if (!subject.empty()) {
            label += QStringLiteral(" ") + QString::fromStdString(subject);
        }
        return QStringLiteral("%1 %2 → %3")
            .arg(label.left(1).toLower() + label.mid(1), widgets::shownValue(from), widgets::shownValue(to));
    };
}

}  // namespace

ScenarioCommand::ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, const QString& key, int gesture)
    : NamedCommand(nameOf(before, after, key)),
      m_document(document),
      m_before(before),
      m_after(after),
      m_key(key),
      m_gesture(gesture) {}

ScenarioCommand::ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, widgets::Wording what)
    : NamedCommand(std::move(what)), m_document(document), m_before(before), m_after(after) {}

bool ScenarioCommand::mergeWith(const QUndoCommand* other) {
    const auto* next = dynamic_cast<const ScenarioCommand*>(other);
    if (next == nullptr || next->m_key != m_key || next->m_gesture != m_gesture) {
        return false;
    }
    m_after = next->m_after;
    setWording(nameOf(m_before, m_after, m_key));
    // Dragged back to where it began: nothing to undo.
    setObsolete(m_after == m_before);
    return true;
}

}  // namespace rubble
