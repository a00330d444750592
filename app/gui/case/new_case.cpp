#include "app/gui/case/new_case.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/gui/case/cloud_reading.h"
#include "app/gui/case/component_display.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/regrouping_edit.h"
#include "core/fe/material.h"
#include "core/fe/terrain_grid.h"
#include "core/fe/units.h"
#include "io/case/case_file.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/case_preview.h"
#include "widgets/case/new_case_wizard.h"

namespace rubble {

namespace {

Aabb boxOf(const Mesh& mesh) {
    Aabb box;
    for (const Vec3& node : mesh.nodes) {
        box.extend(node);
    }
    return box;
}

/// m, of the node that is nearest to a terrain, or deepest below it; unset without nodes.
std::optional<double> clearanceOf(const Mesh& mesh, const TerrainGrid& terrain) {
    std::optional<double> least;
    for (const Vec3& node : mesh.nodes) {
        const double above = node.z() - terrain.height(node.x(), node.y());
        if (!least || above < *least) {
            least = above;
        }
    }
    return least;
}

/// Components whose density no material has.
QString oddDensities(const Components& components) {
    QStringList odd;
    for (const Component& component : components.list) {
        if (!component.elements.empty() && !isMaterialDensity(component.density)) {
            odd << QStringLiteral("%1 (%2)").arg(QString::fromStdString(component.name),
                                                 widgets::shownWith(component.density, "kg/m3", 4));
        }
    }
    return odd.join(QStringLiteral(", "));
}

/// First and last death of each component, by the states that report them.
std::vector<widgets::NewCaseDeaths::Span> spansOf(const FeResult& fe, const Components& components, const Execution& execution) {
    std::vector<widgets::NewCaseDeaths::Span> spans(components.list.size());
    for (std::size_t k = 1; k < fe.stateCount(); ++k) {
        execution.check();
        for (std::size_t c = 0; c < spans.size(); ++c) {
            const auto& elements = components.list[c].elements;
            const bool dies = std::any_of(elements.begin(), elements.end(), [&](ElementIndex e) {
                return fe.activity().active(k - 1, e) && !fe.activity().active(k, e);
            });
            if (dies) {
                if (!spans[c].first) {
                    spans[c].first = fe.times()[k];
                }
                spans[c].last = fe.times()[k];
            }
        }
    }
    return spans;
}

}  // namespace

NewCase::NewCase(const QString& path, std::size_t memoryBytes, bool keepCopies, QWidget& window)
    : QObject(&window),
      m_window(window),
      m_preview(new widgets::CasePreview),
      m_wizard(std::make_unique<widgets::NewCaseWizard>(QFileInfo(path).fileName(), m_preview, &window)),
      m_components(new ComponentDisplay(m_document, m_computation, m_preview->clock(), m_preview->views(),
                                        m_wizard->components().tree(), this)) {
    m_computation.useMemory(memoryBytes);
    m_computation.keepCopies(keepCopies);
    connectWizard();
    connectWork();
    for (widgets::Panel* panel : m_wizard->panels()) {
        panel->setEditable(false);
    }
    m_wizard->setWindowModality(Qt::WindowModal);
    m_wizard->show();
    m_computation.open(path);
}

NewCase::~NewCase() {
    m_computation.disconnect();
    m_computation.cancel();
    m_examiner.disconnect();
    m_examiner.cancel();
    m_document.undoStack().disconnect();
    m_document.disconnect();
    delete m_components;
}

bool NewCase::settled() const {
    return !m_computation.busy() && !m_examiner.busy();
}

void NewCase::connectWizard() {
    widgets::NewCaseWizard& wizard = *m_wizard;
    for (widgets::Panel* panel : wizard.panels()) {
        connect(panel, &widgets::Panel::edited, this, &NewCase::edit);
    }
    connect(&wizard, &QDialog::finished, this, &NewCase::finished);
    connect(&wizard, &widgets::NewCaseWizard::createRequested, this, &NewCase::make);
    connect(&wizard, &widgets::NewCaseWizard::unitsAccepted, this, [this] {
        // The case says then that somebody has chosen.
        if (decidedBy(m_document.scenario().import.units) != Decided::ByName) {
            edit(QStringLiteral("units"), ParameterValue(m_wizard->units().taken()));
        }
    });
    connect(&wizard, &widgets::NewCaseWizard::undoRequested, this, [this] { m_document.undoStack().undo(); });
    connect(&wizard, &widgets::NewCaseWizard::redoRequested, this, [this] { m_document.undoStack().redo(); });
    connect(&wizard, &widgets::NewCaseWizard::stopRequested, this, [this] {
        m_computation.cancel();
        m_examiner.cancel();
    });
    connect(&wizard, &widgets::NewCaseWizard::stepChanged, this, [this](int step) {
        m_preview->setFragmentsShown(step >= widgets::NewCaseWizard::Deaths);
        if (step != widgets::NewCaseWizard::Components) {
            m_preview->mark({});
        }
        audit();
        showSummary();
    });
    connect(&wizard.components(), &widgets::NewCaseComponents::chosen, m_preview, &widgets::CasePreview::mark);
    connect(&wizard.components(), &widgets::NewCaseComponents::regroupRequested, this, [this](const RegroupStep& step) {
        m_document.edit([step] { return widgets::regroupText(step); }, withRegrouping(m_document.scenario(), step));
    });
    connect(&wizard.components(), &widgets::NewCaseComponents::regroupingCleared, this, [this] {
        std::vector<std::string> parts;
        for (const Part& part : m_computation.inputs().fe->mesh().parts) {
            parts.push_back(part.name);
        }
        m_document.edit([] { return tr("regrouping dropped"); }, withoutRegrouping(m_document.scenario(), parts));
    });
    connect(&wizard.ground(), &widgets::NewCaseGround::terrainRequested, this, &NewCase::chooseTerrain);
    connect(&wizard.ground(), &widgets::NewCaseGround::terrainDropped, this, [this] { setTerrain({}); });
    connect(&wizard.deaths(), &widgets::NewCaseDeaths::instantRequested, this, [this](double time) {
        m_preview->clock().pause();
        m_preview->clock().setTime(time);
    });
}

void NewCase::connectWork() {
    connect(&m_computation, &Computation::opened, this, &NewCase::takeOpened);
    connect(&m_computation, &Computation::prepared, this, &NewCase::showResults);
    connect(&m_computation, &Computation::failed, this, &NewCase::showFailure);
    connect(&m_computation, &Computation::progressed, this,
            [this](const QString& what, double fraction) { m_wizard->setProgress(what, fraction); });
    connect(&m_examiner, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) {
        if (!m_computation.busy()) {
            m_wizard->setProgress(widgets::worded(progress.stage), progress.fraction);
        }
    });
    connect(&m_examiner, &Worker::changed, this, [this] {
        if (!m_examiner.busy() && !m_computation.busy()) {
            m_wizard->setProgress({}, 0.0);
        }
    });
    connect(&m_document, &Document::scenarioChanged, this, &NewCase::scenarioChanged);
    connect(&m_document, &Document::inputsChanged, this,
            [this] { m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base()); });
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, &NewCase::showUndo);
}

void NewCase::takeOpened(const Opened& opened) {
    if (!opened.path.isEmpty()) {
        showFailure({[name = QFileInfo(opened.path).fileName()] { return tr("%1 is a case already.").arg(name); },
                     [] { return tr("Open it with Open…, or choose an FE result."); }, "gui.case_already"});
        return;
    }
    if (opened.fe == nullptr && opened.failure && m_document.empty() && !opened.failure->id.starts_with("exodus.")) {
        showFailure(*opened.failure);
        return;
    }
    if (m_document.empty()) {
        Case first = opened.theCase;
        first.scenarios.front().name = tr("As computed").toStdString();
        m_document.replace(first, {}, opened.base);
        m_wizard->summary().propose(QString::fromStdString(first.title), QString::fromStdString(first.scenarios.front().name));
    }
    // Before anything of it is shown.
    if (opened.fe != nullptr) {
        widgets::showTimesFor(opened.fe->times().back() - opened.fe->times().front());
    }
    m_computation.take(opened, m_document.scenario());
    showResults();
}

void NewCase::scenarioChanged() {
    if (m_computation.inputs().fe == nullptr || m_computation.importStale(m_document.scenario())) {
        m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base());
    } else {
        m_computation.update(m_document.scenario());
    }
    showResults();
}

void NewCase::showResults() {
    const auto& fe = m_computation.inputs().fe;
    const Results& results = m_computation.results();
    widgets::NewCaseWizard& wizard = *m_wizard;
    for (widgets::Panel* panel : wizard.panels()) {
        panel->setScenario(m_document.scenario());
        panel->setEditable(!m_document.empty());
        if (!m_computation.failure()) {
            panel->setError({});
        }
    }
    double mass = std::nan("");
    if (fe != nullptr && results.components != nullptr && results.components->of.size() == fe->mesh().elementCount()) {
        mass = 0.0;
        for (const Component& component : results.components->list) {
            mass += component.mass;
        }
    }
    wizard.setOddDensities(std::isnan(mass) ? QString() : oddDensities(*results.components));
    wizard.units().setContent(fe.get(), mass);
    wizard.ground().setStructure(fe != nullptr ? boxOf(fe->mesh()) : Aabb());
    const std::shared_ptr<const TerrainGrid>& terrain = m_computation.inputs().terrain;
    wizard.ground().setTerrain(QString::fromStdString(m_computation.terrain().path),
                               fe != nullptr && terrain ? clearanceOf(fe->mesh(), *terrain) : std::nullopt,
                               m_computation.terrain().findings);
    render::SceneData scene;
    scene.fe = fe;
    scene.components = std::isnan(mass) ? nullptr : results.components;
    scene.fragments = results.fragments;
    scene.clustering = results.clustering;
    scene.setSurroundings(m_document.scenario(), m_computation.inputs().terrain, nullptr);
    m_preview->setData(scene);
    m_components->refresh();
    wizard.components().setContent(scene.components.get());
    wizard.setReady(fe != nullptr && !m_computation.failure());
    lookForEvidence();
    audit();
    showSummary();
    showUndo();
    if (m_makeOnceRead && fe != nullptr && !m_computation.failure() && !m_computation.importStale(m_document.scenario())) {
        make();
    }
}

void NewCase::lookForEvidence() {
    const auto fe = m_computation.inputs().fe;
    if (fe == m_judged) {
        return;
    }
    m_judged = fe;
    if (fe == nullptr) {
        return;
    }
    auto found = std::make_shared<widgets::NewCaseUnits::Evidence>();
    m_examiner.start({Worker::Kind::Open,
                      [fe, found](const Execution& execution) {
                          execution.report({"gui.weighing_units", "Weighing what speaks for the units", {}}, 0.0);
                          const FeResult::Contents& contents = fe->contents();
                          UnitEvidence seen = evidenceOf(contents);
                          addSeenFall(seen, contents, execution);
                          const UnitEvidence evidence = evidenceInFile(std::move(seen), contents.units, contents.frame);
                          *found = {fitUnits(evidence), proposeUnits(evidence), proposeUpAxis(evidence)};
                      },
                      [this, fe, found](const std::exception_ptr& thrown) {
                          if (const auto failure = failureOf(thrown)) {
                              showFailure(*failure);
                          } else if (thrown == nullptr && fe == m_judged) {
                              m_wizard->units().setEvidence(*found);
                              takeBestUnits(*found);
                          }
                      }});
}

// Once, and only where nobody has chosen: taking it back must last.
void NewCase::takeBestUnits(const widgets::NewCaseUnits::Evidence& evidence) {
    const auto fe = m_computation.inputs().fe;
    if (std::exchange(m_unitsTaken, true) || decidedBy(m_document.scenario().import.units) != Decided::ByFrame) {
        return;
    }
    if (const UnitFit* fit = betterFit(evidence.fits, systemOf(fe->contents().units))) {
        edit(QStringLiteral("units"), ParameterValue(std::string(fit->system->id)));
    }
}

void NewCase::audit() {
    const auto fe = m_computation.inputs().fe;
    const auto components = m_computation.results().components;
    const bool asked = m_wizard->step() >= widgets::NewCaseWizard::Deaths;
    const bool fits = fe != nullptr && components != nullptr && components->of.size() == fe->mesh().elementCount() &&
                      !m_computation.stale(Stage::Components, m_document.scenario());
    if (!asked || !fits || components == m_audited) {
        return;
    }
    m_audited = components;
    m_wizard->deaths().setContent(nullptr);
    auto found = std::make_shared<widgets::NewCaseDeaths::Content>();
    m_examiner.start({Worker::Kind::Update,
                      [fe, components, found](const Execution& execution) {
                          execution.report({"gui.auditing", "Accounting for every death", {}}, 0.0);
                          *found = {auditDeaths(*fe, *components, execution), spansOf(*fe, *components, execution)};
                      },
                      [this, components, found](const std::exception_ptr& thrown) {
                          if (const auto failure = failureOf(thrown)) {
                              showFailure(*failure);
                          } else if (thrown == nullptr && components == m_audited) {
                              m_wizard->deaths().setContent(found);
                          } else if (thrown != nullptr && components == m_audited) {
                              m_audited.reset();
                          }
                      }});
}

void NewCase::showSummary() {
    const auto& fe = m_computation.inputs().fe;
    const Results& results = m_computation.results();
    const QString none(QChar(0x2013));
    const UnitSystem* system = fe != nullptr ? systemOf(fe->contents().units) : nullptr;
    const QString terrain = QFileInfo(QString::fromStdString(m_computation.terrain().path)).fileName();
    const bool counted = results.fragments != nullptr && !m_computation.stale(Stage::Fragments, m_document.scenario());
    widgets::NewCaseSummary::Settled settled;
    settled.feResult = fe != nullptr ? QFileInfo(QString::fromStdString(fe->contents().path)).fileName() : none;
    settled.units = system != nullptr ? QString::fromUtf8(system->id.data(), static_cast<qsizetype>(system->id.size()))
                    : fe != nullptr   ? tr("own")
                                      : none;
    settled.upAxis = fe != nullptr ? QString::fromStdString(fe->contents().frame.upAxis) : none;
    settled.ground =
        terrain.isEmpty() ? tr("level, z = %1").arg(widgets::shownLength(m_document.scenario().simulation.groundHeight)) : terrain;
    settled.components =
        results.components != nullptr ? widgets::shownCount(static_cast<std::int64_t>(results.components->list.size())) : none;
    settled.regrouping = widgets::shownCount(static_cast<std::int64_t>(m_document.scenario().regrouping.size()));
    settled.fragments = counted ? widgets::shownCount(static_cast<std::int64_t>(results.fragments->size())) : none;
    m_wizard->summary().setSettled(settled);
}

void NewCase::showUndo() {
    const QUndoStack& stack = m_document.undoStack();
    m_wizard->setUndo(stack.canUndo() ? stack.undoText() : QString(), stack.canRedo() ? stack.redoText() : QString());
}

void NewCase::edit(const QString& key, const ParameterValue& value) {
    try {
        m_document.setParameter(key, value);
    } catch (...) {
        showFailure(*failureOf(std::current_exception()));
        showResults();
    }
}

void NewCase::chooseTerrain() {
    const QString path = QFileDialog::getOpenFileName(m_wizard.get(), tr("Terrain"), QFileInfo(m_document.base()).absolutePath(),
                                                      terrainFileKinds());
    if (!path.isEmpty()) {
        setTerrain(path);
    }
}

void NewCase::setTerrain(const QString& path) {
    std::vector<CaseInput> inputs = m_document.theCase().inputs;
    std::erase_if(inputs, [](const CaseInput& input) { return input.role == InputRole::Terrain; });
    if (!path.isEmpty()) {
        const QDir folder = QFileInfo(m_document.base()).absoluteDir();
        inputs.push_back({"terrain-1", InputRole::Terrain, folder.relativeFilePath(path).toStdString(), ""});
        if (!askCloudReading(m_wizard.get(), inputs.back(), path, m_document.theCase().frame)) {
            return;
        }
    }
    m_document.setInputs(std::move(inputs), [path] {
        return path.isEmpty() ? tr("terrain left out") : tr("terrain %1").arg(QFileInfo(path).fileName());
    });
}

void NewCase::showFailure(const Failure& failure) {
    for (widgets::Panel* panel : m_wizard->panels()) {
        panel->setError(failure.what(), failure.remedy());
    }
    m_wizard->setReady(false);
}

void NewCase::make() {
    // Units that were chosen with the last click are read first.
    m_makeOnceRead = m_computation.importStale(m_document.scenario());
    if (m_computation.inputs().fe == nullptr || m_makeOnceRead) {
        return;
    }
    Opened opened;
    opened.theCase = m_document.theCase();
    opened.theCase.title = m_wizard->summary().title().toStdString();
    for (CaseScenario& scenario : opened.theCase.scenarios) {
        scenario.name = m_wizard->summary().scenarioName().toStdString();
        scenario.note = m_wizard->summary().note().toStdString();
    }
    opened.base = m_document.base();
    opened.fe = m_computation.inputs().fe;
    opened.content = m_computation.content();
    opened.found = m_computation.foundInputs();
    opened.recovered = true;
    emit created(opened, m_preview->views().view());
}

}  // namespace rubble
