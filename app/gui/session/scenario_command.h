#pragma once

#include "app/gui/session/document.h"
#include "app/gui/session/named_command.h"

namespace rubble {

/// The one command that serves all edits: the scenario before and after. Commands of one parameter within one gesture merge.
class ScenarioCommand : public NamedCommand {
public:
    /// An edit of one parameter; gesture < 0: never merges.
    ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, const QString& key, int gesture);
    /// Any other edit, by its name.
    ScenarioCommand(Document& document, const Scenario& before, const Scenario& after, widgets::Wording what);

    void undo() override { m_document.put(m_before); }
    void redo() override { m_document.put(m_after); }
    int id() const override { return m_gesture >= 0 ? 1 : -1; }
    bool mergeWith(const QUndoCommand* other) override;

private:
    Document& m_document;
    Scenario m_before;
    Scenario m_after;
    QString m_key;
    int m_gesture = -1;
};

}  // namespace rubble
