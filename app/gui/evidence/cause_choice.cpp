#include "app/gui/evidence/cause_choice.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>

#include "app/gui/case/project_files.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/session/session.h"
#include "core/scenario/case_lookup.h"
#include "io/case/case_file.h"
#include "io/case/ensemble_source.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_table.h"

namespace rubble {

namespace {

const QString choiceEnding = QStringLiteral(".causes.json");

QString notAtRest() {
    return CauseChoice::tr("It was not taken at rest: members keep their debris at rest.");
}

QString beforeCollapse() {
    return CauseChoice::tr("It was taken before the collapse and shows no debris.");
}

/// Why a photograph does not count; empty: it does. @param photograph  null: nothing is drawn on it
QString whyLeftOut(const Photograph* photograph) {
    const bool drawn = photograph != nullptr && std::any_of(photograph->masks.begin(), photograph->masks.end(),
                                                            [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
    return !drawn                      ? CauseChoice::tr("No outline of the debris is drawn on it.")
           : photograph->time          ? notAtRest()
           : photograph->pairs.empty() ? CauseChoice::tr("Its camera is not matched.")
                                       : QString();
}

QString kindWords(io::EvidenceFile::Kind kind) {
    using Kind = io::EvidenceFile::Kind;
    return kind == Kind::Footprint ? CauseChoice::tr("footprint")
           : kind == Kind::Heights ? CauseChoice::tr("heights")
                                   : CauseChoice::tr("surface");
}

QString named(const QString& kind, const QString& path) {
    return QStringLiteral("%1: %2").arg(kind, QFileInfo(path).fileName());
}

QString timeName(const TimeEvidence& time) {
    return CauseChoice::tr("%1 at %2, %3")
        .arg(widgets::shownWith(time.time, "s", 4), widgets::shownIn(time.place.x(), "m"), widgets::shownWith(time.place.y(), "m"));
}

QString timeTip(const TimeEvidence& time) {
    return CauseChoice::tr(
               "Debris came within %1 of this place so long after the first debris that came down anywhere, give or "
               "take %2")
        .arg(widgets::shownLength(time.radius), widgets::shownWith(time.accuracy, "s"));
}

/// The FE result that a cause is simulated from.
std::string feOf(const StudyCase& cause) {
    const CaseScenario* scenario = findScenario(cause.theCase, cause.scenario);
    const CaseInput* fe = scenario != nullptr ? findFeInput(cause.theCase, *scenario) : nullptr;
    return fe != nullptr ? fe->path : cause.base;
}

void tick(std::set<std::string>& leftOut, const std::string& id, bool used) {
    if (used) {
        leftOut.erase(id);
    } else {
        leftOut.insert(id);
    }
}

}  // namespace

CauseChoice::CauseChoice(Session& session)
    : m_session(session), m_document(session.document()), m_reach(session.part<SurveyReach>()) {
    connect(&m_reach, &SurveyReach::changed, this, &CauseChoice::changed);
    connect(&m_document, &Document::replaced, this, [this] {
        if (m_document.base() != m_base) {
            take();
        }
    });
    connect(&m_document, &Document::titleChanged, this, [this] {
        m_base = m_document.base();
        // Saved elsewhere: the choice goes along.
        if (!m_file.isEmpty() && m_file != m_session.part<ProjectFiles>().runs.fileBeside(choiceEnding)) {
            keep();
        }
    });
    if (!m_document.empty()) {
        take();
    }
}

void CauseChoice::take() {
    m_base = m_document.base();
    m_kept = {};
    m_opened.clear();
    m_file = m_session.part<ProjectFiles>().runs.fileBeside(choiceEnding);
    if (!m_file.isEmpty()) {
        try {
            m_kept = io::readKeptCauses(m_file.toStdString());
        } catch (...) {
            m_session.report(*failureOf(std::current_exception()));
            // What cannot be read is not written over.
            setFileAside(m_file);
        }
    }
    for (const io::KeptCauses::Cause& cause : m_kept.causes) {
        m_opened[cause.path] = openedAgain(cause.path);
    }
    emit replaced();
}

void CauseChoice::keep() {
    m_file = m_session.part<ProjectFiles>().runs.fileBeside(choiceEnding);
    if (m_file.isEmpty()) {
        return;
    }
    try {
        io::writeKeptCauses(m_file.toStdString(), m_kept);
    } catch (...) {
        m_session.report(*failureOf(std::current_exception()));
    }
}

CauseChoice::Opened CauseChoice::open(const std::string& path) {
    const bool isCase = io::isCaseFile(path);
    Opened opened;
    opened.plain = !isCase;
    opened.cause.base = isCase ? path : path + ".rubble";
    opened.cause.theCase = isCase ? io::loadCase(path) : io::caseForFe(path, opened.cause.base);
    opened.cause.name = opened.cause.theCase.title;
    return opened;
}

CauseChoice::Opened CauseChoice::openedAgain(const std::string& path) {
    const QString shown = QString::fromStdString(path);
    Opened gone{{QFileInfo(shown).completeBaseName().toStdString(), {}, path, {}}, false, {}};
    if (!QFileInfo::exists(shown)) {
        gone.failure = {[shown] { return tr("There is no file %1 any more.").arg(shown); },
                        [] { return tr("Put it back, or take it off the list."); }, "gui.cause_gone"};
        return gone;
    }
    try {
        return open(path);
    } catch (...) {
        gone.failure = failureOf(std::current_exception());
        return gone;
    }
}

/// An FE result under the settings, on the site and with the terrain of the open case.
StudyCase CauseChoice::asOpen(const Opened& result, const std::string& path) const {
    const CaseScenario* active = m_document.active();
    if (active == nullptr) {
        return result.cause;
    }
    return {result.cause.name, io::caseOfCause(m_document.theCase(), *active, path), m_document.base().toStdString(), active->id};
}

std::vector<CauseChoice::Cause> CauseChoice::causes() const {
    std::vector<Cause> all;
    const Case& theCase = m_document.theCase();
    const std::string base = m_document.base().toStdString();
    for (const CaseScenario& scenario : theCase.scenarios) {
        const std::string& name = theCase.scenarios.size() > 1 ? scenario.name : theCase.title;
        all.push_back({{name, theCase, base, scenario.id},
                       tr("A scenario of this case"),
                       {},
                       !m_kept.leftOutScenarios.contains(scenario.id)});
    }
    for (const io::KeptCauses::Cause& added : m_kept.causes) {
        const Opened& opened = m_opened.at(added.path);
        all.push_back({opened.plain ? asOpen(opened, added.path) : opened.cause, QString::fromStdString(added.path),
                       opened.failure ? opened.failure->inOneLine() : QString(), added.used, true});
    }
    std::vector<std::string> taken;
    for (Cause& cause : all) {
        StudyCase& study = cause.study;
        const std::string name = study.name.empty() ? std::filesystem::path(study.base).stem().string() : study.name;
        study.name = io::causeName(name, feOf(study), taken);
        taken.push_back(study.name);
    }
    return all;
}

std::vector<EvidenceRow> CauseChoice::ownEvidence() const {
    std::vector<EvidenceRow> rows = evidenceOf(m_document.theCase());
    std::erase_if(rows, [](const EvidenceRow& row) {
        return row.form == EvidenceForm::Points || (row.held && *row.held != PointsHeld::Outline);
    });
    return rows;
}

QString CauseChoice::whyNot(const CaseInput& survey) const {
    const auto isIt = [&, base = m_document.base().toStdString()](const io::KeptCauses::File& added) {
        return io::surveyOfFile(m_document.theCase(), base, added.file.path) == &survey;
    };
    Findings far = m_reach.of(survey);
    far.append(m_reach.unread(survey));
    return survey.before    ? beforeCollapse()
           : survey.instant ? notAtRest()
           : !far.empty()   ? widgets::worded(far.list().front().what)
           : std::any_of(m_kept.files.begin(), m_kept.files.end(), isIt)
               ? tr("It is listed below as well, as what it was added as: that counts.")
               : QString();
}

std::vector<CauseChoice::Evidence> CauseChoice::evidence() const {
    std::vector<Evidence> all;
    const Case& theCase = m_document.theCase();
    for (const EvidenceRow& row : ownEvidence()) {
        const QString name = named(widgets::evidenceFormText(row.form), QString::fromStdString(row.path));
        const bool used = !m_kept.leftOutEvidence.contains(row.id);
        if (row.form == EvidenceForm::Photograph) {
            const auto photograph = std::find_if(theCase.photographs.begin(), theCase.photographs.end(),
                                                 [&](const Photograph& each) { return each.input == row.id; });
            const QString why = whyLeftOut(photograph != theCase.photographs.end() ? &*photograph : nullptr);
            all.push_back({row.id, row.id, name, tr("A photograph of this case, taken at rest"), why, used});
        } else {
            const auto survey = std::find_if(theCase.inputs.begin(), theCase.inputs.end(),
                                             [&](const CaseInput& each) { return each.id == row.id; });
            const io::EvidenceFile file{io::EvidenceFile::Kind::Survey, io::inputPath(m_document.base().toStdString(), *survey)};
            all.push_back({file, row.id, name, tr("A survey of this case: noise, areas and registration count as the case says"),
                           whyNot(*survey), used});
        }
    }
    for (const io::KeptCauses::File& each : m_kept.files) {
        const QString path = QString::fromStdString(each.file.path);
        const CaseInput* survey = io::surveyOfFile(theCase, m_document.base().toStdString(), each.file.path);
        const QString why = survey == nullptr ? QString()
                            : survey->before  ? beforeCollapse()
                            : survey->instant ? notAtRest()
                                              : QString();
        all.push_back({each.file, {}, named(kindWords(each.file.kind), path), path, why, each.used});
    }
    for (const io::KeptCauses::Time& each : m_kept.times) {
        all.push_back({each.time, {}, timeName(each.time), timeTip(each.time), {}, each.used});
    }
    return all;
}

CauseOrder CauseChoice::order() const {
    CauseOrder order;
    for (Cause& cause : causes()) {
        if (cause.used && cause.why.isEmpty()) {
            order.causes.push_back(std::move(cause.study));
        }
    }
    for (const Evidence& each : evidence()) {
        if (!each.used || !each.why.isEmpty()) {
            continue;
        }
        if (const auto* file = std::get_if<io::EvidenceFile>(&each.what)) {
            order.files.push_back(*file);
        } else if (const auto* time = std::get_if<TimeEvidence>(&each.what)) {
            order.times.push_back(*time);
        } else {
            order.photographs.push_back(std::get<std::string>(each.what));
        }
    }
    order.photographed = m_document.theCase();
    order.base = m_document.base().toStdString();
    order.blind = m_kept.blind;
    return order;
}

void CauseChoice::addCause(const QString& path) {
    const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
    const bool known = std::any_of(m_kept.causes.begin(), m_kept.causes.end(), [&](const auto& each) { return each.path == file; });
    m_opened[file] = open(file);
    if (!known) {
        m_kept.causes.push_back({file});
    }
}

void CauseChoice::addFile(const io::EvidenceFile& file) {
    if (std::none_of(m_kept.files.begin(), m_kept.files.end(), [&](const auto& each) { return each.file == file; })) {
        m_kept.files.push_back({file});
    }
}

void CauseChoice::addTime(const TimeEvidence& time) {
    if (std::none_of(m_kept.times.begin(), m_kept.times.end(), [&](const auto& each) { return each.time.name == time.name; })) {
        m_kept.times.push_back({time});
    }
}

void CauseChoice::useCause(std::size_t cause, bool used) {
    const std::vector<CaseScenario>& own = m_document.theCase().scenarios;
    if (cause < own.size()) {
        tick(m_kept.leftOutScenarios, own[cause].id, used);
    } else if (cause - own.size() < m_kept.causes.size()) {
        m_kept.causes[cause - own.size()].used = used;
    }
}

void CauseChoice::useEvidence(std::size_t evidence, bool used) {
    const std::vector<EvidenceRow> own = ownEvidence();
    const std::size_t added = evidence - own.size();
    if (evidence < own.size()) {
        tick(m_kept.leftOutEvidence, own[evidence].id, used);
    } else if (added < m_kept.files.size()) {
        m_kept.files[added].used = used;
    } else if (added - m_kept.files.size() < m_kept.times.size()) {
        m_kept.times[added - m_kept.files.size()].used = used;
    }
}

void CauseChoice::removeCause(std::size_t cause) {
    const std::size_t added = cause - m_document.theCase().scenarios.size();
    if (added < m_kept.causes.size()) {
        m_opened.erase(m_kept.causes[added].path);
        m_kept.causes.erase(m_kept.causes.begin() + static_cast<std::ptrdiff_t>(added));
    }
}

void CauseChoice::removeEvidence(std::size_t evidence) {
    const std::size_t added = evidence - ownEvidence().size();
    if (added < m_kept.files.size()) {
        m_kept.files.erase(m_kept.files.begin() + static_cast<std::ptrdiff_t>(added));
    } else if (added - m_kept.files.size() < m_kept.times.size()) {
        m_kept.times.erase(m_kept.times.begin() + static_cast<std::ptrdiff_t>(added - m_kept.files.size()));
    }
}

}  // namespace rubble
