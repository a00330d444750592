// The part of the computation that keeps runs: the current one of a file, and those of other scenarios beside it.
#include <QFile>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/session/computation.h"
#include "core/base/error.h"
#include "io/run/acknowledgements.h"

namespace rubble {

namespace {

/// A run of this window's own goes with its file.
void dropFile(const RunRecord& run) {
    if (!run.kept) {
        QFile::remove(run.path);
    }
}

/// Id of the units that settings read a file in; words of case files where nothing else is known.
std::string unitsOf(const ImportSettings& settings, const Frame& frame) {
    if (decidedBy(settings.units) == Decided::ByFrame && frame.metresPerUnit == 1.0) {
        return "kg-m-s";
    }
    return std::string(unitChoices()[settings.units]);
}

/// A run stands on the FE result as it was read then: read otherwise, places and masses of the two would be mixed.
void checkReading(const std::string& path, const io::RunOrigin& run, const ImportSettings& now, const Frame& frame) {
    const std::string then = unitsOf(run.scenario.import, run.frame);
    const std::string units = unitsOf(now, frame);
    if (then != units || run.frame.metresPerUnit != frame.metresPerUnit) {
        throw UsageError({"gui.run_in_other_units",
                          "{0} was made of the FE result in the units {1}; the case reads it in {2}",
                          {path, then, units}},
                         {"gui.run_in_other_units.remedy",
                          "Set the units of the file to {0} under Case to show this run, or simulate anew.",
                          {then}});
    }
    ImportSettings like = run.scenario.import;
    like.units = now.units;
    like.upAxis = now.upAxis;
    if (!(like == now) || run.frame.upAxis != frame.upAxis || run.frame.origin != frame.origin) {
        throw UsageError(
            {"gui.run_read_otherwise",
             "{0} was made of the FE result with another axis, origin, active flag or displacement than the case has now",
             {path}},
            {"gui.run_read_otherwise.remedy", "Set them back under Case to show this run, or simulate anew.", {}});
    }
}

/// Reads a run that was kept. What it was made from comes from its own file, the components from its settings.
void readKept(RunRecord& record, const Inputs& inputs, const ImportSettings& import, const Results& previous,
              const Execution& execution) {
    record.reader = io::openRun(record.path.toStdString());
    const io::RunOrigin& origin = record.reader->origin();
    if (origin.feSha256 != inputs.fe->contents().sha256) {
        throw UsageError(
            {"gui.run_of_another", "{0} was made from another FE result than the one that is open", {record.path.toStdString()}},
            {"gui.run_of_another.remedy", "Open the case that it belongs to.", {}});
    }
    checkReading(record.path.toStdString(), origin, import, inputs.frame);
    record.scenario = origin.scenario;
    record.scenarioName = QString::fromStdString(origin.scenarioName);
    record.results = run(inputs, origin.scenario, Stage::Clusters, previous, nullptr, execution);
    if (record.reader->fragments() != nullptr && record.reader->clustering() != nullptr) {
        record.results.fragments = record.reader->fragments();
        record.results.clustering = record.reader->clustering();
    }
    record.outcome = record.reader->result();
    record.results.simulation = record.outcome;
    record.soFar.breaches = record.reader->breaches();
    record.acknowledged = io::taintOf(*record.reader).acknowledgement;
    record.newest = record.reader->frameCount() > 0 ? record.reader->frameTime(record.reader->frameCount() - 1) : 0.0;
}

}  // namespace

void Computation::keepNoMore() {
    if (simulating() && m_run->kept) {
        m_run->kept = false;
        m_run->remover = std::shared_ptr<void>(nullptr, [path = m_run->path](void*) { QFile::remove(path); });
    }
}

void Computation::showRun(const QString& path, double wallSeconds) {
    if (m_opened.inputs.fe == nullptr || simulating()) {
        return;
    }
    readRun(path, wallSeconds, [this](const std::shared_ptr<RunRecord>& record) {
        if (!simulating()) {
            const std::shared_ptr<RunRecord> older = std::exchange(m_run, record);
            setAside(older, record);
            m_pace.reset();
            emit runReopened();
        }
    });
}

void Computation::readRun(const QString& path, double wallSeconds,
                          const std::function<void(const std::shared_ptr<RunRecord>&)>& take) {
    auto record = std::make_shared<RunRecord>();
    record->path = path;
    record->kept = true;
    record->wallSeconds = wallSeconds;
    m_worker.start({Worker::Kind::Reopen,
                    [record, inputs = m_opened.inputs, import = m_import, previous = m_results](const Execution& execution) {
                        execution.report({"gui.opening_run", "Opening the run", {}}, 0.0);
                        readKept(*record, inputs, import, previous, execution);
                    },
                    [this, record, take, fe = m_opened.inputs.fe](const std::exception_ptr& thrown) {
                        if (const auto failure = failureOf(thrown)) {
                            fail(*failure);
                        } else if (thrown == nullptr && fe == m_opened.inputs.fe) {
                            take(record);
                        }
                        emit stateChanged();
                    }});
}

void Computation::setAside(const std::shared_ptr<RunRecord>& older, const std::shared_ptr<RunRecord>& newer) {
    if (older == nullptr || older == newer) {
        return;
    }
    if (older->outcome != nullptr && older->scenarioName != newer->scenarioName) {
        addOther(older);
    } else {
        dropFile(*older);
    }
}

void Computation::addOther(const std::shared_ptr<const RunRecord>& run) {
    const auto place = std::lower_bound(m_others.begin(), m_others.end(), run,
                                        [](const auto& a, const auto& b) { return a->scenarioName < b->scenarioName; });
    if (place != m_others.end() && (*place)->scenarioName == run->scenarioName) {
        if ((*place)->path != run->path) {
            dropFile(**place);
        }
        *place = run;
    } else {
        m_others.insert(place, run);
    }
    emit otherRunsChanged(run->scenarioName);
}

void Computation::dropOthers() {
    for (const auto& run : m_others) {
        dropFile(*run);
    }
    m_others.clear();
    emit otherRunsChanged({});
}

void Computation::openOther(const QString& path) {
    if (m_opened.inputs.fe == nullptr) {
        return;
    }
    readRun(path, std::nan(""), [this](const std::shared_ptr<RunRecord>& record) { addOther(record); });
}

}  // namespace rubble
