#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>

#include "app/gui/session/worker.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/evidence/ensembles/telling_evidence.h"
#include "core/pipeline/time_left.h"
#include "io/case/ensemble_source.h"
#include "io/site/cause_evidence.h"

namespace rubble {

/// A case as an ensemble is asked of it.
struct StudyCase {
    std::string name;  ///< of the cause; empty: as the case says
    Case theCase;
    std::string base;                     ///< what its inputs are relative to
    std::optional<std::string> scenario;  ///< only this one
};

/// How an ensemble is to be made.
struct StudyOrder {
    EnsembleSettings settings;
    SurfaceSettings surface;
    DebrisInstant instant = DebrisInstant::AtRest;
    io::OpenResult open;  ///< that need not be read a second time
    bool copies = false;  ///< FE results through compressed copies
};

/// How the scenarios of a case are opened for its ensemble.
io::CaseRequest caseRequest(const StudyCase& of, const StudyOrder& order);

/// How the members are made and measured. @param machine  in words
EnsembleOptions optionsOf(const StudyOrder& order, const std::string& machine, SettledStore& store);

/// An ensemble, and what it was made from.
struct MadeEnsemble {
    std::shared_ptr<const EnsembleReport> report;
    io::EnsembleBasis basis;
};

/// What several causes are held against.
struct CauseOrder {
    std::vector<StudyCase> causes;
    std::vector<io::EvidenceFile> files;
    std::vector<TimeEvidence> times;
    std::vector<std::string> photographs;  ///< ids of inputs of the first case that are to be used
    Case photographed;                     ///< the case that has them, and says what of its surveys is compared
    std::string base;                      ///< file that its inputs are relative to
    bool blind = false;
};

/// Causes that were compared.
struct MadeComparison {
    std::vector<std::string> causes;
    std::vector<Hypothesis> hypotheses;
    std::shared_ptr<const CauseComparison> comparison;  ///< null: there was no evidence
    std::vector<BlindTest> blind;
    std::shared_ptr<const TellingEvidence> further;  ///< where causes could not be told apart, or blind tests were asked for
    io::EnsembleBasis basis;
    Findings findings;
};

/// Simulates ensembles in the background, on a worker of its own so that the case can be edited meanwhile. Members are kept in the
/// user's cache as those of the command line are: a second start goes on from there.
class StudyWork : public QObject {
    Q_OBJECT

public:
    explicit StudyWork(QObject* parent = nullptr);

    /// Simulates one ensemble; answers with ensembleGrew(), progressed() and ended().
    void simulate(const StudyCase& of, const StudyOrder& order);
    /// Simulates the ensembles of several causes and compares them; answers with compared(), progressed() and ended().
    void compare(const CauseOrder& causes, const StudyOrder& order);
    void cancel();
    /// Cancels, and takes nothing any more of what runs.
    void forget();
    bool running() const { return m_running != Kind::Nothing; }
    /// Tells once more how far it has got.
    void tellProgress() { m_worker.tellProgress(); }
    bool simulating() const { return m_running == Kind::Ensemble; }
    bool comparing() const { return m_running == Kind::Causes; }

signals:
    void begun();
    void ensembleGrew(const rubble::MadeEnsemble& made);
    void compared(const std::shared_ptr<const rubble::MadeComparison>& made);
    /// @param secondsLeft  NaN: not known yet
    void progressed(const QString& what, double fraction, double secondsLeft);
    /// @param failure  null: it came to its end or was cancelled
    void ended(const rubble::Failure* failure);

private:
    enum class Kind { Nothing, Ensemble, Causes };
    void showProgress(const Progress& progress);
    void start(Kind kind, std::function<void(const Execution&)> work);

    Kind m_running = Kind::Nothing;
    int m_generation = 0;  // what comes in from an older start is not taken
    TimeLeft m_left;
    std::atomic<int> m_at{-1};  // the cause whose members are being simulated, written by the worker; below zero: none yet
    int m_causes = 0;
    std::string m_machine;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
