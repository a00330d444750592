#include "app/gui/accuracy/reference_work.h"

#include <QFile>
#include <filesystem>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/run/checkpoint_file.h"

namespace rubble {

namespace {

/// Recorded frames per second: between two of them a fall bends by 12 mm at most.
constexpr double referenceFrames = 10.0;

std::shared_ptr<io::RunReader> openKept(const Digest& key) {
    try {
        const std::string path = ReferenceWork::pathOf(key).toStdString();
        if (!std::filesystem::exists(path)) {
            return nullptr;
        }
        std::shared_ptr<io::RunReader> reader = io::openRun(path);
        return reader->complete() && reader->origin().fingerprint == key ? reader : nullptr;
    } catch (const Error&) {
        // A damaged file is no reference; it is made again when one is asked for.
        return nullptr;
    }
}

void simulateInto(const std::string& path, const Inputs& inputs, const Scenario& scenario, const io::RunOrigin& origin,
                  const Execution& execution) {
    const Results prepared = run(inputs, scenario, Stage::Clusters, {}, nullptr, execution);
    io::CheckpointFile checkpoint(io::checkpointPathOf(path));
    std::unique_ptr<TrajectorySink> sink = io::continueRun(path, origin);
    run(inputs, scenario, Stage::Simulation, prepared, sink.get(), execution, &checkpoint);
    sink.reset();
    checkpoint.remove();
}

}  // namespace

Scenario comparedReference(const Scenario& scenario) {
    Scenario reference = referenceScenario(scenario);
    reference.simulation.frameRate = referenceFrames;
    return reference;
}

ReferenceWork::ReferenceWork(QObject* parent) : QObject(parent) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind kind, const Progress& progress) {
        if (kind != Worker::Kind::Simulate || !m_running) {
            return;
        }
        emit progressed(progress.fraction, m_left.after(progress));
    });
}

QString ReferenceWork::pathOf(const Digest& key) {
    return QString::fromStdString((std::filesystem::path(io::cacheFolder()) / "references" / (key.hex() + ".run.h5")).string());
}

void ReferenceWork::look(const Inputs& inputs, const Scenario& scenario) {
    const Scenario reference = comparedReference(scenario);
    const Digest key = stageKey(inputs, reference, Stage::Simulation);
    if (m_running || (key == m_key && (m_reader != nullptr || m_looking))) {
        return;
    }
    m_key = key;
    m_reader.reset();
    m_looking = true;
    auto found = std::make_shared<std::shared_ptr<io::RunReader>>();
    m_worker.startNext({Worker::Kind::Open, [key, found](const Execution&) { *found = openKept(key); },
                        [this, key, found](const std::exception_ptr&) {
                            if (key == m_key) {
                                m_looking = false;
                                m_reader = *found;
                                emit changed();
                            }
                        }});
    emit changed();
}

void ReferenceWork::start(const Inputs& inputs, const Scenario& scenario, io::RunOrigin origin) {
    if (m_running) {
        return;
    }
    const Scenario reference = comparedReference(scenario);
    const Digest key = stageKey(inputs, reference, Stage::Simulation);
    origin.scenario = reference;
    origin.scenarioName = "reference";
    origin.build = std::string(buildText());
    origin.fingerprint = key;
    m_key = key;
    m_reader.reset();
    m_running = true;
    m_looking = false;
    m_left.restart();
    auto made = std::make_shared<std::shared_ptr<io::RunReader>>();
    m_worker.start({Worker::Kind::Simulate,
                    [inputs, reference, key, origin, made](const Execution& execution) {
                        const std::string path = pathOf(key).toStdString();
                        std::filesystem::create_directories(std::filesystem::path(path).parent_path());
                        // Complete, or not there at all.
                        const std::string unfinished = path + ".part";
                        try {
                            simulateInto(unfinished, inputs, reference, origin, execution);
                            std::filesystem::rename(unfinished, path);
                        } catch (...) {
                            std::error_code ignored;
                            std::filesystem::remove(unfinished, ignored);
                            throw;
                        }
                        *made = openKept(key);
                    },
                    [this, key, made](const std::exception_ptr& thrown) {
                        m_running = false;
                        if (key == m_key) {
                            m_reader = *made;
                        }
                        const auto failure = failureOf(thrown);
                        emit ended(failure ? &*failure : nullptr);
                    }});
    emit changed();
}

void ReferenceWork::clear() {
    m_worker.cancel();
    m_key = {};
    m_reader.reset();
    m_looking = false;
    emit changed();
}

void ReferenceWork::cancel() {
    m_worker.cancel();
    // What had not started yet never ends by itself.
    if (m_running && !m_worker.busy(Worker::Kind::Simulate)) {
        m_running = false;
        emit ended(nullptr);
    }
}

}  // namespace rubble
