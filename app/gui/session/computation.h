#pragma once

#include <QLockFile>
#include <QObject>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "app/gui/session/watched_sink.h"
#include "app/gui/session/worker.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/remedies.h"
#include "core/scenario/case.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/case/input_check.h"
#include "io/case/open_case.h"
#include "io/run/run_file.h"
#include "widgets/views/stage_rail.h"

namespace rubble {

/// What was read when a file was opened; `fe` is missing when only the case could be read.
struct Opened {
    Case theCase;
    QString path;  ///< of the case file, empty for a bare FE result
    QString base;  ///< what its inputs are relative to
    std::shared_ptr<const FeResult> fe;
    std::optional<Failure> failure;
    io::OpenedCase content;             ///< all that `fe` stands on
    std::vector<io::FoundInput> found;  ///< what lies where the case says that its inputs are
    bool recovered = false;             ///< the case has changes that were never saved

    /// A case, or an FE result as far as one can tell; anything else leaves open what was.
    bool recognised() const;
};

/// A run as the window has it: its file, what it was made from, and its outcome.
struct RunRecord {
    QString path;
    bool kept = false;                ///< the file stays when the window is done with it
    std::shared_ptr<QLockFile> lock;  ///< while the file is written
    std::shared_ptr<void> remover;    ///< removes the file with the record, where it lies among kept ones and is none any more
    bool live = false;
    QString scenarioName;  ///< as it was called when it was simulated
    Scenario scenario;
    Results results;  ///< what it was made from; `simulation` once it is complete
    std::shared_ptr<io::RunReader> reader;
    bool running = false;
    double newest = 0.0;  ///< s, time of the last committed frame
    double wallSeconds = 0.0;
    std::shared_ptr<const SimulationResult> outcome;
    HealthReport soFar;                           ///< its breaches up to the newest frame, while there is no outcome
    std::optional<Acknowledgement> acknowledged;  ///< somebody vouches for it in spite of its breaches

    /// What the monitor saw; its breaches only, while the run is not complete.
    const HealthReport& health() const {
        const SimulationResult* made = outcome.get();
        return made != nullptr ? made->health : soFar;
    }
    /// What the remedies of its findings are chosen by.
    RemedyGrounds grounds() const {
        const SimulationResult* made = outcome.get();
        return {scenario, made != nullptr ? meanStepRate(made->steps, made->endTime - made->firstTime) : 0.0};
    }
};

/// Whether what was opened may take the place of what is there.
enum class Welcome { Now, Later, Never };

/// What is kept of the files that are read.
struct Keeping {
    bool copies = false;                       ///< a compressed copy of every FE result
    std::size_t bytes = std::size_t{2} << 30;  ///< of states and frames in memory

    std::size_t stateBytes() const { return bytes - frameBytes(); }
    std::size_t frameBytes() const { return bytes / 3; }
};

/// What has been computed for the open case: the FE result, the results by stage and the run. Starts the work on the worker and
/// tells the window; results that a change has made stale stay until newer ones replace them.
class Computation : public QObject {
    Q_OBJECT

public:
    explicit Computation(QObject* parent = nullptr);
    ~Computation() override;

    /// Reads a case or an FE result; answers with opened().
    void open(const QString& path);
    /// Reads the FE result of an open case anew, with other import settings; answers with opened().
    /// @param recovered  the case has changes that were never saved
    void reopen(const Case& theCase, const QString& path, const QString& base, bool recovered = false);
    /// Takes what was opened and prepares it up to the clusters.
    void take(const Opened& opened, const Scenario& scenario);
    /// @param welcome  asked before what was opened stops what runs, and again before opened() tells of it; without it: always now
    void welcomeBy(std::function<Welcome(const Opened&)> welcome) { m_welcome = std::move(welcome); }
    /// Whether FE results are opened through copies in the cache folder.
    void keepCopies(bool keep) { m_keeping.copies = keep; }
    /// @param folder  where the files of runs are kept, asked before each; empty or without it: they go with the case
    void keepRunsIn(std::function<QString()> folder) { m_runFolder = std::move(folder); }
    /// No runs are kept any more: the one at work goes with the case as well. Those that have ended stay.
    void keepNoMore();
    /// Bytes that states and frames of what is opened from now on may take.
    void useMemory(std::size_t bytes) { m_keeping.bytes = bytes; }
    void clear();
    /// Brings all stages before the simulation up to a changed scenario.
    void update(const Scenario& scenario);
    /// Simulates; answers with runBegun(), runGrew() and runEnded().
    void simulate(const Scenario& scenario, const QString& scenarioName, bool live);
    /// Shows a run that was kept in place of the last one; answers with runReopened() or failed().
    /// @param wallSeconds  that it took, as far as that is known
    void showRun(const QString& path, double wallSeconds);
    /// Opens a kept run of the FE result that is open to be shown beside the current one; answers with otherRunsChanged() or
    /// failed().
    void openOther(const QString& path);
    /// Long work that writes a file, with progress and cancel, after what is being written; `done` gets what it threw.
    void write(std::function<void(const Execution&)> work, std::function<void(std::exception_ptr)> done);
    void cancel();
    /// Someone vouches for the last run in spite of its breaches; answers with acknowledged() or failed().
    void acknowledge(const QString& name, const QString& note);

    bool busy() const { return m_worker.busy() || m_opener.busy(); }
    /// How many pieces of work wait for those that run.
    int waiting() const { return m_worker.waiting() + m_opener.waiting(); }
    /// Tells once more how far what runs has got.
    void tellProgress();
    /// Work for this stage runs or waits.
    bool busy(Stage stage) const {
        return m_worker.busy(stage == Stage::Simulation ? Worker::Kind::Simulate : Worker::Kind::Update);
    }
    bool simulating() const { return m_run != nullptr && m_run->running; }
    const Inputs& inputs() const { return m_opened.inputs; }
    /// The terrain of the case as it was read; without grid if there is none.
    const io::TerrainInput& terrain() const { return m_opened.terrain; }
    /// The case as it was read last, with all that it stands on.
    const io::OpenedCase& content() const { return m_opened; }
    /// The FE result that is open, for work that need not read it a second time.
    io::OpenResult openResult() const { return {m_opened.fePath, m_import, m_opened.inputs.fe}; }
    /// What was found on opening, by every stage and by the current run; one row for each kind.
    Findings findings() const;
    /// The case names other SHA-256 of its inputs now: what was a finding may be none, and the other way round.
    void acceptInputs(const std::vector<CaseInput>& inputs);
    /// What lay where the case says that its inputs are, when they were last read.
    const std::vector<io::FoundInput>& foundInputs() const { return m_found; }
    const Results& results() const { return m_results; }
    /// The newest complete run of each other scenario that was simulated or opened in this window, in the order of their names.
    const std::vector<std::shared_ptr<const RunRecord>>& otherRuns() const { return m_others; }
    const RunRecord* currentRun() const { return m_run.get(); }
    const std::shared_ptr<LivePace>& livePace() const { return m_pace; }
    /// Which effects take part and why; null until a scene is there to decide on.
    const std::shared_ptr<const EffectDecisions>& decisions() const { return m_decisions; }
    /// Whether they were decided for other settings; false if there are none.
    bool decisionsStale(const Scenario& scenario) const;
    /// Whether what a stage has is older than the scenario; false if it has nothing.
    bool stale(Stage stage, const Scenario& scenario) const;
    /// Whether the FE result was read with other import settings than the scenario's.
    bool importStale(const Scenario& scenario) const;
    bool runStale(const Scenario& scenario) const;
    /// The case has this scenario now: what is exported of the run says whether it has outgrown the run.
    void judgeRun(const Scenario& scenario) const;
    /// The state of a stage as the rail shows it, with its progress.
    widgets::StageState state(Stage stage, const Scenario& scenario) const;
    double fraction(Stage stage) const;
    const std::optional<Failure>& failure() const { return m_failure; }
    /// The terrain that the case names could not be read, so that nothing is open.
    bool terrainFailed() const { return m_opened.inputs.fe == nullptr && m_failure && m_failure->id.starts_with("terrain."); }

signals:
    void opened(const rubble::Opened& opened);
    /// The inputs of the case were looked for; foundInputs() says what is there.
    void inputsFound();
    /// Results before the simulation have changed.
    void prepared();
    void runBegun();
    /// A frame was committed; at most about 25 times a second, in live mode for every frame.
    void runGrew(double time);
    void runEnded(bool complete);
    /// A kept run is the current one now.
    void runReopened();
    /// Runs that can be shown beside the current one have come or gone. @param newest  scenario of the one that came, or empty
    void otherRunsChanged(const QString& newest);
    /// Effects were decided.
    void decided();
    /// The last run was acknowledged, or could not be: what was said against it.
    void acknowledged(const QString& complaint);
    /// Something went wrong; failure() says what. Work that was asked for before goes on.
    void failed(const rubble::Failure& failure);
    /// What runs has got on; empty text when nothing runs.
    void progressed(const QString& what, double fraction);
    void stateChanged();

private:
    void startOpening(std::function<Opened(const Execution&)> read);
    void whenWelcome(const std::shared_ptr<const Opened>& opened, int opening, const std::function<void()>& go);
    void replaceBy(const std::shared_ptr<const Opened>& opened, int opening);
    void tell(const Opened& opened);
    Results prepareOnWorker(const Inputs& inputs, const Scenario& scenario, const Results& previous, const Execution& execution);
    void decideOnWorker(const Inputs& inputs, const Scenario& scenario, const Results& results);
    void adopt(const Results& newer, Stage last);
    std::shared_ptr<const SimulationResult> simulateOnWorker(const std::shared_ptr<RunRecord>& record, const Inputs& inputs,
                                                             const Results& previous, const io::RunOrigin& origin,
                                                             const std::shared_ptr<LivePace>& pace, const Execution& execution);
    void began(const std::shared_ptr<RunRecord>& record, const std::shared_ptr<io::RunReader>& reader, const Results& from);
    void committed(const std::shared_ptr<RunRecord>& record, double time);
    void ended(const std::shared_ptr<RunRecord>& record, const std::shared_ptr<const SimulationResult>& outcome, double wall,
               const std::exception_ptr& thrown);
    /// Reads a run that was kept and hands it over, if the FE result is still the same by then.
    void readRun(const QString& path, double wallSeconds, const std::function<void(const std::shared_ptr<RunRecord>&)>& take);
    void setAside(const std::shared_ptr<RunRecord>& older, const std::shared_ptr<RunRecord>& newer);
    void addOther(const std::shared_ptr<const RunRecord>& run);
    void dropOthers();
    void fail(const Failure& failure);
    void showProgress(Worker::Kind kind, const Progress& progress);
    QString scratchPath();

    Keeping m_keeping;
    std::function<Welcome(const Opened&)> m_welcome;
    int m_openings = 0;
    io::OpenedCase m_opened;
    std::vector<io::FoundInput> m_found;
    ImportSettings m_import;  // with which the FE result was read
    Results m_results;
    std::shared_ptr<const EffectDecisions> m_decisions;
    Digest m_decidedFor;  // decisionKey() of what they were decided for
    std::shared_ptr<RunRecord> m_run;
    std::vector<std::shared_ptr<const RunRecord>> m_others;
    std::shared_ptr<LivePace> m_pace;
    std::optional<Failure> m_failure;
    std::optional<Stage> m_runningStage;
    double m_fraction = 0.0;
    double m_openFraction = 0.0;
    std::unique_ptr<QTemporaryDir> m_scratch;
    std::unique_ptr<QLockFile> m_scratchLock;  ///< tells later programs whether this one has died
    std::function<QString()> m_runFolder;
    int m_runs = 0;
    // Last, so that the workers have ended before anything they use goes.
    Worker m_worker;
    Worker m_opener;  // beside the other: what cannot be read takes nothing from what runs
};

}  // namespace rubble
