#include "app/gui/session/document.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <map>

#include "app/gui/session/moved_inputs.h"
#include "app/gui/session/named_command.h"
#include "app/gui/session/sample.h"
#include "app/gui/session/scenario_command.h"
#include "app/gui/session/step_command.h"

namespace rubble {

Document::Document(QObject* parent) : QObject(parent) {
    m_undo.setUndoLimit(500);
    connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

const CaseScenario* Document::active() const {
    for (const CaseScenario& each : m_case.scenarios) {
        if (each.id == m_case.activeScenario) {
            return &each;
        }
    }
    return m_case.scenarios.empty() ? nullptr : &m_case.scenarios.front();
}

const Scenario& Document::scenario() const {
    static const Scenario none;
    const CaseScenario* found = active();
    return found != nullptr ? found->scenario : none;
}

void Document::replace(Case theCase, const QString& path, const QString& base, bool changed) {
    // It tells of a stack that is clean: of the case that goes, for nobody knows the new one yet.
    m_undo.clear();
    m_case = std::move(theCase);
    m_path = path;
    m_base = base;
    {
        const QSignalBlocker untold(m_undo);  // it is told below, with the case
        if (changed) {
            m_undo.resetClean();
        } else {
            // An empty stack is not cleared, and would hold the new case for changed where the one before came back unsaved.
            m_undo.setClean();
        }
    }
    emit replaced();
    emit titleChanged();
}

void Document::close() {
    replace(Case(), {}, {});
}

void Document::saved(Case asSaved, const QString& path) {
    m_case = std::move(asSaved);
    m_path = path;
    m_base = path;
    m_undo.setClean();
    emit titleChanged();
}

void Document::put(const Scenario& scenario) {
    if (const CaseScenario* found = active()) {
        m_case.scenarios[static_cast<std::size_t>(found - m_case.scenarios.data())].scenario = scenario;
        emit scenarioChanged();
    }
}

// Whoever may write everything is told by the rights of the file alone.
bool Document::isReadOnly(const QString& path) {
    return !path.isEmpty() && QFileInfo::exists(path) && (!QFileInfo(path).permission(QFile::WriteOwner) || isSample(path));
}

QString Document::openPath() const {
    if (empty() || !m_path.isEmpty()) {
        return m_path;
    }
    // A result without a case lies where its case would, less the ending.
    return m_base.chopped(QStringLiteral(".rubble").size());
}

bool Document::standsOn(const Case& theCase) const {
    const auto bare = [](Case of) {
        of.photographs.clear();
        of.removals.clear();
        of.ensemble = {};
        of.evidence = {};
        std::erase_if(of.inputs, [](const CaseInput& input) {
            return input.role == InputRole::Photograph || input.role == InputRole::Survey;
        });
        return of;
    };
    return bare(theCase) == bare(m_case);
}

void Document::setParameter(const QString& key, const ParameterValue& value) {
    Scenario after = scenario();
    rubble::setParameter(after, key.toStdString(), value);
    if (empty() || after == scenario()) {
        return;
    }
    m_undo.push(new ScenarioCommand(*this, scenario(), after, key, m_inGesture ? m_gesture : -1));
}

void Document::nameEdits() {
    for (int i = 0; i < m_undo.count(); ++i) {
        // The stack lends its commands for reading; what they are called is for the screen alone.
        if (auto* edit = dynamic_cast<NamedCommand*>(const_cast<QUndoCommand*>(m_undo.command(i)))) {
            edit->name();
        }
    }
    emit m_undo.indexChanged(m_undo.index());
}

void Document::edit(const widgets::Wording& what, const Scenario& after) {
    if (!empty() && !(after == scenario())) {
        m_undo.push(new ScenarioCommand(*this, scenario(), after, what));
    }
}

void Document::setInputs(std::vector<CaseInput> inputs, const widgets::Wording& what) {
    if (!empty() && !(inputs == m_case.inputs)) {
        // Paths are relative to where the case lies now; it may lie elsewhere when this is undone.
        const auto way = [this, base = m_base](std::vector<CaseInput> to) {
            return [this, base, inputs = std::move(to)] { putInputs(inputs, base); };
        };
        m_undo.push(new StepCommand(what, way(std::move(inputs)), way(m_case.inputs)));
    }
}

void Document::setSurveys(std::vector<CaseInput> inputs, const widgets::Wording& what) {
    if (empty() || inputs == m_case.inputs) {
        return;
    }
    const auto way = [this, base = m_base](std::vector<CaseInput> to) {
        return [this, base, files = std::move(to)] {
            m_case.inputs = base == m_base ? files : movedInputs(files, base, m_base);
            emit surveysChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(std::move(inputs)), way(m_case.inputs)));
}

void Document::setRemovals(std::vector<Removal> removals, const widgets::Wording& what) {
    std::stable_sort(removals.begin(), removals.end(), [](const Removal& a, const Removal& b) { return a.time < b.time; });
    if (empty() || removals == m_case.removals) {
        return;
    }
    const auto way = [this](std::vector<Removal> to) {
        return [this, to = std::move(to)] {
            m_case.removals = to;
            emit surveysChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(std::move(removals)), way(m_case.removals)));
}

void Document::setSite(const Site& site, const std::string& crs, const std::vector<std::optional<Vec3>>& offsets,
                       const widgets::Wording& what) {
    using Offsets = std::map<std::string, std::optional<Vec3>>;
    Offsets before;
    Offsets after;
    for (const CaseInput& input : m_case.inputs) {
        if (input.role == InputRole::Surroundings) {
            after[input.id] = after.size() < offsets.size() ? offsets[after.size()] : input.offset;
            before[input.id] = input.offset;
        }
    }
    if (empty() || (site == m_case.site && crs == m_case.frame.crs && before == after)) {
        return;
    }
    const auto way = [this](const Site& to, const std::string& system, const Offsets& moved) {
        return [this, to, system, moved] {
            m_case.site = to;
            m_case.frame.crs = system;
            for (CaseInput& input : m_case.inputs) {
                if (const auto offset = moved.find(input.id); offset != moved.end()) {
                    input.offset = offset->second;
                }
            }
            emit inputsChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(site, crs, after), way(m_case.site, m_case.frame.crs, before)));
}

void Document::putInputs(const std::vector<CaseInput>& inputs, const QString& base) {
    std::vector<CaseInput> now = base == m_base ? inputs : movedInputs(inputs, base, m_base);
    const bool sameFiles =
        std::equal(now.begin(), now.end(), m_case.inputs.begin(), m_case.inputs.end(),
                   [](const CaseInput& a, const CaseInput& b) { return a.id == b.id && a.role == b.role && a.path == b.path; });
    m_case.inputs = std::move(now);
    if (sameFiles) {
        emit inputsAccepted();
    } else {
        emit inputsChanged();
    }
}

const CaseScenario* Document::scenarioOf(const std::string& id) const {
    const auto found =
        std::find_if(m_case.scenarios.begin(), m_case.scenarios.end(), [&](const CaseScenario& each) { return each.id == id; });
    return found != m_case.scenarios.end() ? &*found : nullptr;
}

void Document::changeScenarios(std::vector<CaseScenario> scenarios, const std::string& active, const widgets::Wording& what) {
    if (scenarios == m_case.scenarios && active == m_case.activeScenario) {
        return;
    }
    const auto way = [this](std::vector<CaseScenario> to, std::string which) {
        return [this, to = std::move(to), which = std::move(which)] { putScenarios(to, which); };
    };
    m_undo.push(new StepCommand(what, way(std::move(scenarios), active), way(m_case.scenarios, m_case.activeScenario)));
}

void Document::putScenarios(const std::vector<CaseScenario>& scenarios, const std::string& active) {
    const CaseScenario before = this->active() != nullptr ? *this->active() : CaseScenario();
    m_case.scenarios = scenarios;
    m_case.activeScenario = active;
    const CaseScenario& after = *this->active();
    emit scenariosChanged();
    emit titleChanged();
    if (after.feInput != before.feInput) {
        emit inputsChanged();
    } else if (!(after.scenario == before.scenario)) {
        emit scenarioChanged();
    }
}

void Document::duplicateScenario(const std::string& id) {
    const CaseScenario* of = scenarioOf(id);
    if (of == nullptr) {
        return;
    }
    const auto taken = [this](const auto& is) { return std::any_of(m_case.scenarios.begin(), m_case.scenarios.end(), is); };
    CaseScenario copy = *of;
    for (std::size_t n = m_case.scenarios.size() + 1; taken([&](const CaseScenario& each) { return each.id == copy.id; }); ++n) {
        copy.id = "scenario-" + std::to_string(n);
    }
    const QString name = QString::fromStdString(of->name);
    copy.name = tr("%1, copy").arg(name).toStdString();
    for (int n = 2; taken([&](const CaseScenario& each) { return each.name == copy.name; }); ++n) {
        copy.name = tr("%1, copy %2").arg(name).arg(n).toStdString();
    }
    std::vector<CaseScenario> all = m_case.scenarios;
    all.insert(all.begin() + (of - m_case.scenarios.data()) + 1, copy);
    changeScenarios(std::move(all), copy.id, [made = QString::fromStdString(copy.name)] { return tr("scenario “%1”").arg(made); });
}

void Document::renameScenario(const std::string& id, const QString& name) {
    if (const CaseScenario* of = scenarioOf(id); of != nullptr && !name.trimmed().isEmpty()) {
        std::vector<CaseScenario> all = m_case.scenarios;
        all[static_cast<std::size_t>(of - m_case.scenarios.data())].name = name.trimmed().toStdString();
        changeScenarios(std::move(all), m_case.activeScenario, [before = QString::fromStdString(of->name), after = name.trimmed()] {
            return tr("scenario “%1” renamed to “%2”").arg(before, after);
        });
    }
}

void Document::setScenarioNote(const std::string& id, const QString& note) {
    if (const CaseScenario* of = scenarioOf(id)) {
        std::vector<CaseScenario> all = m_case.scenarios;
        all[static_cast<std::size_t>(of - m_case.scenarios.data())].note = note.toStdString();
        changeScenarios(std::move(all), m_case.activeScenario,
                        [name = QString::fromStdString(of->name)] { return tr("note on “%1”").arg(name); });
    }
}

void Document::removeScenario(const std::string& id) {
    const CaseScenario* of = scenarioOf(id);
    if (of == nullptr || m_case.scenarios.size() < 2) {
        return;
    }
    const auto place = static_cast<std::size_t>(of - m_case.scenarios.data());
    std::vector<CaseScenario> all = m_case.scenarios;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(place));
    const std::string next = id == this->active()->id ? all[std::min(place, all.size() - 1)].id : m_case.activeScenario;
    changeScenarios(std::move(all), next,
                    [name = QString::fromStdString(of->name)] { return tr("scenario “%1” deleted").arg(name); });
}

void Document::activateScenario(const std::string& id) {
    if (const CaseScenario* of = scenarioOf(id); of != nullptr && of != active()) {
        changeScenarios(m_case.scenarios, id,
                        [name = QString::fromStdString(of->name)] { return tr("to scenario “%1”").arg(name); });
    }
}

void Document::setBookmarks(std::vector<Bookmark> bookmarks, const widgets::Wording& what) {
    std::stable_sort(bookmarks.begin(), bookmarks.end(), [](const Bookmark& a, const Bookmark& b) { return a.time < b.time; });
    if (empty() || bookmarks == m_case.bookmarks) {
        return;
    }
    const auto way = [this](std::vector<Bookmark> to) {
        return [this, to = std::move(to)] {
            m_case.bookmarks = to;
            emit bookmarksChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(std::move(bookmarks)), way(m_case.bookmarks)));
}

void Document::setCameraKeys(std::vector<CameraKey> keys, const widgets::Wording& what) {
    std::stable_sort(keys.begin(), keys.end(), [](const CameraKey& a, const CameraKey& b) { return a.time < b.time; });
    if (empty() || keys == m_case.cameraKeys) {
        return;
    }
    const auto way = [this](std::vector<CameraKey> to) {
        return [this, to = std::move(to)] {
            m_case.cameraKeys = to;
            emit cameraKeysChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(std::move(keys)), way(m_case.cameraKeys)));
}

void Document::setPhotographs(std::vector<Photograph> photographs, std::vector<CaseInput> inputs, const widgets::Wording& what) {
    if (empty() || (photographs == m_case.photographs && inputs == m_case.inputs)) {
        return;
    }
    const auto way = [this](std::vector<Photograph> to, std::vector<CaseInput> files) {
        return [this, to = std::move(to), files = std::move(files), base = m_base] {
            m_case.photographs = to;
            m_case.inputs = base == m_base ? files : movedInputs(files, base, m_base);
            emit photographsChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(std::move(photographs), std::move(inputs)), way(m_case.photographs, m_case.inputs)));
}

void Document::setEvidence(const EvidenceSettings& evidence, const widgets::Wording& what) {
    if (empty() || evidence == m_case.evidence) {
        return;
    }
    const auto way = [this](const EvidenceSettings& to) {
        return [this, to] {
            m_case.evidence = to;
            emit evidenceChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(evidence), way(m_case.evidence)));
}

void Document::setEnsemble(const EnsembleSettings& ensemble, const widgets::Wording& what) {
    if (empty() || ensemble == m_case.ensemble) {
        return;
    }
    const auto way = [this](const EnsembleSettings& to) {
        return [this, to] {
            m_case.ensemble = to;
            emit ensembleChanged();
        };
    };
    m_undo.push(new StepCommand(what, way(ensemble), way(m_case.ensemble)));
}

void Document::applyPreset(const QString& name) {
    Scenario after = scenario();
    rubble::applyPreset(after, name.toStdString());
    edit([name] { return tr("preset %1").arg(name); }, after);
}

void Document::beginGesture() {
    ++m_gesture;
    m_inGesture = true;
}

void Document::endGesture() {
    m_inGesture = false;
}

}  // namespace rubble
