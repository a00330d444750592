#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/run_entry.h"
#include "core/scenario/case.h"

namespace rubble {

class Computation;
class Document;
class Session;
struct RunRecord;
namespace widgets {
struct Preferences;
}

/// The runs of the open case, kept beside it from their begin on, so that none is lost with its program: beside the case that has
/// it now, wherever its file lies (io/run/run_history.h); in the state folder for a case that was never saved or lies where nothing
/// can be written.
class RunHistory : public QObject {
    Q_OBJECT

public:
    /// @param folder  in the state folder; empty: nothing is kept there
    RunHistory(Session& session, const QString& folder, QObject* parent = nullptr);

    const std::vector<RunEntry>& runs() const { return m_runs; }
    /// The run that is shown, if it is in the list.
    std::optional<std::size_t> shown() const { return m_shown; }
    /// The newest complete run of a scenario; null if none is known.
    const RunEntry* newestOf(const std::string& scenarioId) const;
    /// A run of the scenario that is worked on is about to begin.
    void begins();
    /// The file of the run that is shown was kept here.
    void keptAt(const QString& path);
    /// Where the runs of the open case are kept; empty: nowhere, so that they go with the case.
    QString runsFolder() const;
    /// Where runs of cases lie for which there is no room beside them; empty: nowhere.
    const QString& stateFolder() const { return m_folder; }
    /// The history of a case that nothing can be written beside; empty: there is no such folder.
    QString stateFile() const;
    /// Where something else that is said of the open case is kept, likewise beside it or in the state folder; empty: nowhere.
    /// @param ending  behind the name of the case, such as ".report.json"
    QString fileBeside(const QString& ending) const;
    /// Run files have come or gone.
    void filesChanged() { emit changed(); }
    /// A run that was kept and that simulating now would only repeat: the same inputs, settings and program. Unset: there is none.
    std::optional<std::size_t> sameAsNow() const;
    /// Shows a kept run again; answers through Computation::runReopened() or failed().
    void show(std::size_t place);

signals:
    void changed();

private:
    void load();
    void began();
    void ended();
    void adoptBegun();
    bool writesBeside() const;
    RunEntry entryOf(const RunRecord& record) const;
    void noteAcknowledged();
    void takePreferences(const widgets::Preferences& before);
    void store();
    void findFiles();
    void makeRoom();
    QString makeFolder();
    std::vector<RunEntry> read(const QString& file);
    QString sidecar() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    QString m_folder;
    std::vector<RunEntry> m_runs;
    std::optional<std::size_t> m_shown;
    std::optional<std::size_t> m_asked;
    std::optional<CaseScenario> m_starting;
    bool m_began = false;
    std::vector<RunEntry> m_unlisted;  ///< that are being written, here or by another program: kept with the others, not shown
    QString m_loadedFor;
};

}  // namespace rubble
