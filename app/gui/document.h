#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>

#include "core/scenario/case.h"
#include "core/scenario/parameters.h"

namespace rubble {

/// The case that the window works on, where it lies, and the one undo stack. Every edit is one command on the scenario value; edits
/// of one gesture (a slider that is dragged) merge into one.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    bool empty() const { return m_case.scenarios.empty(); }
    const Case& theCase() const { return m_case; }
    const Scenario& scenario() const;
    const CaseScenario* active() const;
    /// Where the case lies; empty until it is saved.
    const QString& path() const { return m_path; }
    /// The file that inputs are relative to: where the case lies or would lie.
    const QString& base() const { return m_base; }
    bool modified() const { return !empty() && !m_undo.isClean(); }
    QUndoStack& undoStack() { return m_undo; }

    /// Takes another case; the undo stack starts anew.
    /// @param path  where it lies, empty for one that was never saved; @param base  what its inputs are relative to
    void replace(Case theCase, const QString& path, const QString& base);
    void close();
    /// What has been saved under this path; inputs were made relative to it.
    void saved(Case asSaved, const QString& path);

    /// Sets a parameter as one undoable command named "label before → after". Throws UsageError.
    void setParameter(const QString& key, const ParameterValue& value);
    /// Any other change of the scenario as one undoable command.
    void edit(const QString& what, const Scenario& after);
    /// Another set of input files as one undoable command.
    void setInputs(std::vector<CaseInput> inputs, const QString& what);
    /// A preset is one command too.
    void applyPreset(const QString& name);
    /// Edits of one parameter between these two are one step of undo.
    void beginGesture();
    void endGesture();

signals:
    void replaced();
    void scenarioChanged();
    /// The case stands on other files now: they are to be read.
    void inputsChanged();
    void titleChanged();

private:
    friend class ScenarioCommand;
    friend class InputsCommand;
    void put(const Scenario& scenario);
    void putInputs(const std::vector<CaseInput>& inputs);

    Case m_case;
    QString m_path;
    QString m_base;
    QUndoStack m_undo;
    int m_gesture = 0;
    bool m_inGesture = false;
};

}  // namespace rubble
