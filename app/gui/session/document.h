#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <optional>
#include <vector>

#include "core/scenario/case.h"
#include "core/scenario/parameters.h"
#include "widgets/basics/wording.h"

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
    /// It lies in a file that is not to be written, as the case of a sealed bundle or a sample that comes with the program:
    /// changes are saved elsewhere, and what is said of it goes to the state folder.
    bool readOnly() const { return isReadOnly(m_path); }
    static bool isReadOnly(const QString& path);
    /// The file that inputs are relative to: where the case lies or would lie.
    const QString& base() const { return m_base; }
    /// The case, or the FE result that is open without one; empty if nothing is.
    QString openPath() const;
    /// Whether a case is this one, evidence and ensemble apart: they may be edited while its files are read.
    bool standsOn(const Case& theCase) const;
    bool modified() const { return !empty() && !m_undo.isClean(); }
    QUndoStack& undoStack() { return m_undo; }
    /// Names all edits in the language that is spoken now.
    void nameEdits();

    /// Takes another case; the undo stack starts anew.
    /// @param path  where it lies, empty for one that was never saved; @param base  what its inputs are relative to
    /// @param changed  it has changes that are not saved (recovered work)
    void replace(Case theCase, const QString& path, const QString& base, bool changed = false);
    void close();
    /// What has been saved under this path; inputs were made relative to it.
    void saved(Case asSaved, const QString& path);

    /// Sets a parameter as one undoable command named "label before → after". Throws UsageError.
    void setParameter(const QString& key, const ParameterValue& value);
    /// Any other change of the scenario as one undoable command.
    void edit(const widgets::Wording& what, const Scenario& after);
    /// Another set of input files as one undoable command.
    void setInputs(std::vector<CaseInput> inputs, const widgets::Wording& what);
    /// Other surveys among the input files as one undoable command; no result depends on them.
    void setSurveys(std::vector<CaseInput> inputs, const widgets::Wording& what);
    /// Other places whose debris was removed, put into the order of their times, as one undoable command.
    void setRemovals(std::vector<Removal> removals, const widgets::Wording& what);
    /// How the case lies in the world as one undoable command: terrain and surroundings are read anew.
    /// @param offsets  of the meshes of surroundings, in the order of the inputs
    void setSite(const Site& site, const std::string& crs, const std::vector<std::optional<Vec3>>& offsets,
                 const widgets::Wording& what);
    /// A copy of a scenario under another name becomes the one that is worked on.
    void duplicateScenario(const std::string& id);
    void renameScenario(const std::string& id, const QString& name);
    void setScenarioNote(const std::string& id, const QString& note);
    /// The last one stays: a case without scenario cannot be simulated.
    void removeScenario(const std::string& id);
    /// Works on another scenario from here on.
    void activateScenario(const std::string& id);
    /// Bookmarks, put into the order of their times, as one undoable command.
    void setBookmarks(std::vector<Bookmark> bookmarks, const widgets::Wording& what);
    /// Camera keys of movies, put into the order of their times, as one undoable command.
    void setCameraKeys(std::vector<CameraKey> keys, const widgets::Wording& what);
    /// Other photographs, and the files that they are, as one undoable command; no result depends on them.
    void setPhotographs(std::vector<Photograph> photographs, std::vector<CaseInput> inputs, const widgets::Wording& what);
    /// How evidence is held against runs, as one undoable command; no run depends on it.
    void setEvidence(const EvidenceSettings& evidence, const widgets::Wording& what);
    /// What an ensemble of the case varies, as one undoable command; no result depends on it.
    void setEnsemble(const EnsembleSettings& ensemble, const widgets::Wording& what);
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
    /// What is said of the files has changed, not which they are.
    void inputsAccepted();
    /// Their names, their notes, how many there are or which one is worked on.
    void scenariosChanged();
    void bookmarksChanged();
    void cameraKeysChanged();
    void photographsChanged();
    void surveysChanged();
    void ensembleChanged();
    void evidenceChanged();
    void titleChanged();

private:
    friend class ScenarioCommand;
    void put(const Scenario& scenario);
    void putInputs(const std::vector<CaseInput>& inputs, const QString& base);
    void putScenarios(const std::vector<CaseScenario>& scenarios, const std::string& active);
    void changeScenarios(std::vector<CaseScenario> scenarios, const std::string& active, const widgets::Wording& what);
    const CaseScenario* scenarioOf(const std::string& id) const;

    Case m_case;
    QString m_path;
    QString m_base;
    QUndoStack m_undo;
    int m_gesture = 0;
    bool m_inGesture = false;
};

}  // namespace rubble
