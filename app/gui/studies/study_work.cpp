#include "app/gui/studies/study_work.h"

#include <algorithm>
#include <numeric>

#include "core/evidence/ensembles/member_doubts.h"
#include "io/base/machine.h"
#include "io/run/settled_files.h"
#include "io/site/input_files.h"
#include "widgets/basics/wording.h"

namespace rubble {

io::CaseRequest caseRequest(const StudyCase& of, const StudyOrder& order) {
    io::CaseRequest request;
    request.path = of.base;
    request.theCase = of.theCase;
    request.scenario = of.scenario;
    request.cached = order.copies;
    request.open = order.open;
    return request;
}

EnsembleOptions optionsOf(const StudyOrder& order, const std::string& machine, SettledStore& store) {
    EnsembleOptions options;
    options.instant = order.instant;
    options.surface = order.surface;
    options.machine = machine;
    options.store = &store;
    return options;
}

namespace {

/// The causes, opened. They must be of one site.
std::vector<io::EnsembleSource> openCauses(const CauseOrder& causes, const StudyOrder& order, const Execution& execution) {
    std::vector<io::EnsembleSource> sources;
    std::vector<std::string> names;
    for (const StudyCase& cause : causes.causes) {
        const std::string& shown = cause.name.empty() ? cause.theCase.title : cause.name;
        execution.report({"gui.opening_cause", "Opening \"{0}\"", {shown}}, 0.0);
        io::EnsembleSource source = io::openEnsemble(caseRequest(cause, order), order.settings, execution);
        if (!cause.name.empty()) {
            source.name = cause.name;
        }
        io::joinCauses(source, sources.empty() ? nullptr : &sources.front(), names);
        names.push_back(source.name);
        sources.push_back(std::move(source));
    }
    return sources;
}

CauseEvidence readAll(const CauseOrder& causes, const StudyOrder& order, const io::EnsembleSource& first, MadeComparison& made,
                      const Execution& execution) {
    CauseEvidence evidence;
    evidence.times = causes.times;
    const EnsembleScene& scene = first.scenes.front();
    io::EvidenceSite site{first.frame, first.theCase.site, {true, scene.scenario.simulation.groundHeight, scene.inputs.terrain}};
    site.groundFile = io::evidenceGround(first);
    site.groundRead = first.terrainRead;
    for (const io::EvidenceFile& file : causes.files) {
        execution.check();
        const CaseInput stated = io::statedOfFile(causes.photographed, causes.base, file.path, {}, made.findings);
        evidence.surfaces.push_back(io::readEvidence(file, site, stated, order.surface, made.findings, execution));
        made.basis.inputs.push_back({"evidence", file.path, io::digestOfInput(file.path, InputRole::Survey, execution).sha256});
    }
    Case chosen = causes.photographed;
    std::erase_if(chosen.photographs, [&](const Photograph& photograph) {
        return std::find(causes.photographs.begin(), causes.photographs.end(), photograph.input) == causes.photographs.end();
    });
    evidence.photographs = io::photographsAsEvidence(chosen, made.findings, execution);
    return evidence;
}

MadeComparison compareAll(const CauseOrder& causes, const StudyOrder& order, const std::string& machine, std::atomic<int>& at,
                          const Execution& execution) {
    MadeComparison made;
    const std::vector<io::EnsembleSource> sources = openCauses(causes, order, execution);
    made.basis.frame = sources.front().frame;
    made.basis.site = sources.front().theCase.site;
    const CauseEvidence evidence = readAll(causes, order, sources.front(), made, execution);
    io::SettledFiles files(io::cacheFolder());
    for (const io::EnsembleSource& source : sources) {
        EnsembleOptions options = optionsOf(order, machine, files);
        if (!evidence.photographs.empty()) {
            options.look = [&](const MemberSite& site, const Execution& own) {
                return lookedAt(evidence, site, order.surface, own);
            };
        }
        EnsembleSettings settings = order.settings;
        if (source.scenes.size() == 1) {
            std::erase_if(settings.varied, [](const VariedSetting& varied) { return varied.key == scenarioKey; });
        }
        at = static_cast<int>(made.hypotheses.size());
        auto report = std::make_shared<EnsembleReport>(ensembleStudy(source.scenes, settings, options, execution));
        execution.check();
        made.findings.append(source.findings);
        made.basis.join(source.basis());
        made.causes.push_back(source.name);
        made.hypotheses.push_back({source.name, std::move(report)});
    }
    made.findings.append(findingsOfMembers(made.hypotheses));
    if (evidence.count() > 0) {
        auto comparison = std::make_shared<const CauseComparison>(compareCauses(made.hypotheses, evidence));
        made.findings.append(comparison->findings);
        made.comparison = std::move(comparison);
    }
    if (causes.blind || evidence.count() == 0) {
        for (const EvidenceKind kind : {EvidenceKind::Footprint, EvidenceKind::Heights}) {
            made.blind.push_back(blindTest(made.hypotheses, kind, execution));
            made.findings.append(made.blind.back().findings);
        }
    }
    const bool open = made.comparison == nullptr || !made.comparison->ranking.decided();
    if (made.hypotheses.size() > 1 && (open || causes.blind)) {
        std::vector<std::size_t> apart(made.hypotheses.size());
        std::iota(apart.begin(), apart.end(), std::size_t{0});
        if (made.comparison != nullptr) {
            apart = notToldApart(*made.comparison);
        }
        // A cause without a member that could be compared is told from none.
        if (apart.size() > 1) {
            const EnsembleScene& scene = sources.front().scenes.front();
            const SiteSurface ground{true, scene.scenario.simulation.groundHeight, scene.inputs.terrain};
            made.further =
                std::make_shared<const TellingEvidence>(tellingEvidence(made.hypotheses, evidence, apart, ground, execution));
        }
    }
    return made;
}

}  // namespace

StudyWork::StudyWork(QObject* parent) : QObject(parent), m_machine(io::machineText()) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) { showProgress(progress); });
}

void StudyWork::showProgress(const Progress& progress) {
    if (!running()) {
        return;
    }
    QString what = widgets::worded(progress.stage);
    Progress whole = progress;
    if (const int at = m_at; comparing() && at >= 0 && m_causes > 0) {
        what = tr("cause %1 of %2: %3").arg(at + 1).arg(m_causes).arg(what);
        whole = {{"gui.causes", "", {}}, (at + std::clamp(progress.fraction, 0.0, 1.0)) / m_causes};
    }
    emit progressed(what, std::clamp(whole.fraction, 0.0, 1.0), m_left.after(whole));
}

void StudyWork::start(Kind kind, std::function<void(const Execution&)> work) {
    m_running = kind;
    m_left.restart();
    m_worker.start({Worker::Kind::Study, std::move(work), [this, generation = m_generation](const std::exception_ptr& thrown) {
                        if (generation == m_generation) {
                            m_running = Kind::Nothing;
                            const auto failure = failureOf(thrown);
                            emit ended(failure ? &*failure : nullptr);
                        }
                    }});
    emit begun();
}

void StudyWork::simulate(const StudyCase& of, const StudyOrder& order) {
    const int generation = ++m_generation;
    start(Kind::Ensemble, [this, of, order, generation, machine = m_machine](const Execution& execution) {
        const io::EnsembleSource source = io::openEnsemble(caseRequest(of, order), order.settings, execution);
        io::SettledFiles files(io::cacheFolder());
        EnsembleOptions options = optionsOf(order, machine, files);
        const auto tell = [&](const EnsembleReport& report) {
            const MadeEnsemble made{std::make_shared<const EnsembleReport>(report), source.basis()};
            QMetaObject::invokeMethod(
                this,
                [this, generation, made] {
                    if (generation == m_generation) {
                        emit ensembleGrew(made);
                    }
                },
                Qt::QueuedConnection);
        };
        options.grown = tell;
        EnsembleReport report = ensembleStudy(source.scenes, order.settings, options, execution);
        report.findings.append(source.findings);
        tell(report);
    });
}

void StudyWork::compare(const CauseOrder& causes, const StudyOrder& order) {
    const int generation = ++m_generation;
    m_at = -1;
    m_causes = static_cast<int>(causes.causes.size());
    start(Kind::Causes, [this, causes, order, generation, machine = m_machine](const Execution& execution) {
        const auto made = std::make_shared<const MadeComparison>(compareAll(causes, order, machine, m_at, execution));
        QMetaObject::invokeMethod(
            this,
            [this, generation, made] {
                if (generation == m_generation) {
                    emit compared(made);
                }
            },
            Qt::QueuedConnection);
    });
}

void StudyWork::cancel() {
    m_worker.cancel();
    // What had not started yet never ends by itself.
    if (running() && !m_worker.busy(Worker::Kind::Study)) {
        m_running = Kind::Nothing;
        emit ended(nullptr);
    }
}

void StudyWork::forget() {
    ++m_generation;
    m_worker.cancel();
    m_running = Kind::Nothing;
}

}  // namespace rubble
