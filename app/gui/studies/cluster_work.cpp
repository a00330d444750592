#include "app/gui/studies/cluster_work.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>

#include "app/gui/session/document.h"
#include "core/base/error.h"
#include "core/scenario/case_lookup.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/jobs/program.h"
#include "io/jobs/slurm_words.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

constexpr int askAgainAfter = 5000;  // ms
// Collecting may take this share of the time at most.
constexpr int collectedShare = 4;

}  // namespace

ClusterWork::ClusterWork(std::string store, QObject* parent) : QObject(parent), m_store(std::move(store)) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) {
        if (m_running) {
            emit progressed(widgets::worded(progress.stage), std::clamp(progress.fraction, 0.0, 1.0), m_left.after(progress));
        }
    });
}

void ClusterWork::start(Study study) {
    run(std::move(study), true);
}

void ClusterWork::resume(Study study) {
    run(std::move(study), false);
}

void ClusterWork::run(Study study, bool told) {
    const int generation = ++m_generation;
    m_cancels = false;
    m_left.restart();
    const auto begins = [this, generation] {
        if (generation == m_generation && !m_running) {
            m_running = true;
            m_left.restart();
            emit begun();
        }
    };
    const auto found = [this, begins] { QMetaObject::invokeMethod(this, begins, Qt::QueuedConnection); };
    m_worker.start({Worker::Kind::Study,
                    [this, study = std::move(study), found](const Execution& execution) { follow(study, execution, found); },
                    [this, generation](const std::exception_ptr& thrown) { finish(generation, thrown); }});
    if (told) {
        begins();
    }
}

void ClusterWork::follow(const Study& study, const Execution& execution, const std::function<void()>& found) {
    const std::optional<std::string> id = study.begin(execution);
    if (!id) {
        return;
    }
    found();
    if (id->empty()) {
        study.collect({}, execution);
        return;
    }
    using Clock = std::chrono::steady_clock;
    io::SlurmJobs jobs(m_store);
    std::optional<std::size_t> collected;
    Clock::time_point next;
    const auto collect = [&](const io::JobProgress& progress, const Execution& own) {
        const Clock::time_point from = Clock::now();
        study.collect(progress, own);
        collected = progress.made;
        next = Clock::now() + (collectedShare - 1) * (Clock::now() - from);
    };
    try {
        const auto looked = [&](const io::JobProgress& progress) {
            if (collected != progress.made && Clock::now() >= next) {
                collect(progress, execution);
            }
        };
        collect(jobs.follow(*id, looked, execution), execution);
    } catch (const Cancelled&) {
        if (!m_cancels) {
            throw;
        }
        jobs.cancel(*id);
        collect(jobs.look(*id), Execution().withThreads(execution.threads()));
    }
}

void ClusterWork::finish(int generation, const std::exception_ptr& thrown) {
    if (generation != m_generation) {
        return;
    }
    const bool told = m_running;
    m_running = false;
    const auto failure = failureOf(thrown);
    if (told || failure) {
        emit ended(failure ? &*failure : nullptr);
    }
}

void ClusterWork::cancelJob() {
    m_cancels = true;
    m_worker.cancel();
}

void ClusterWork::forget() {
    ++m_generation;
    m_worker.cancel();
    m_running = false;
}

void ClusterWork::probe() {
    if (m_probed.isValid() && m_probed.elapsed() < askAgainAfter) {
        return;
    }
    m_probed.start();
    m_asking.start({Worker::Kind::Study, [](const Execution&) { io::Slurm::reach(); },
                    [this](const std::exception_ptr& thrown) {
                        const auto failure = failureOf(thrown);
                        emit reached(failure ? failure->what() : QString(), failure ? failure->remedy() : QString());
                    }});
}

std::string commandLineProgram() {
    std::string path = io::programBeside("rubble-cli");
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        throw WorldError({"gui.no_command_line", "There is no {0}, which makes the worlds on the cluster.", {path}},
                         {"gui.no_command_line.remedy", "Install rubble-cli beside rubble.", {}});
    }
    return path;
}

JobCase jobCaseOf(const Document& document) {
    JobCase of{document.theCase(), document.base().toStdString(), document.path().toStdString()};
    const CaseScenario* active = document.active();
    const CaseInput* input = active != nullptr ? findFeInput(of.theCase, *active) : nullptr;
    if (input != nullptr) {
        of.subject = io::inputPath(of.base, *input);
    }
    return of;
}

bool mayCancelJob(QWidget* parent) {
    return QMessageBox::question(parent, QCoreApplication::translate("ClusterWork", "Cancel on the cluster?"),
                                 QCoreApplication::translate(
                                     "ClusterWork",
                                     "The worlds that wait or run are taken from the cluster. What is made is kept, and starting "
                                     "again submits only what is missing."),
                                 QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

std::string keepJobCase(const std::string& store, const std::string& id, const JobCase& of) {
    Case kept = of.theCase;
    for (CaseInput& input : kept.inputs) {
        input.path = io::inputPath(of.base, input);
    }
    kept.journal = {};
    const std::filesystem::path folder = std::filesystem::path(io::jobsFolder(store)) / id;
    std::error_code ignored;  // writing says what is wrong
    std::filesystem::create_directories(folder, ignored);
    const std::string path = (folder / "case.rubble").string();
    io::writeAtomically(path, [&](std::ostream& out) { out << io::caseText(kept); });
    return path;
}

Findings findingsOf(const io::JobProgress& progress) {
    Findings findings;
    for (const io::JobTask& task : progress.failed) {
        const io::SlurmReason reason = io::taskReason(task);
        findings.add(reason.what, reason.remedy, task.name);
    }
    return findings;
}

}  // namespace rubble
