#include "app/gui/evidence/causes_display.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <iterator>

#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/map_export.h"
#include "app/gui/session/session.h"
#include "core/evidence/ensembles/study_tables.h"
#include "core/scenario/case_lookup.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/ensemble_origin.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/causes_page.h"
#include "widgets/evidence/causes_panel.h"

namespace rubble {

namespace {

/// A case without what no comparison depends on.
Case bare(Case of) {
    of.title.clear();
    of.bookmarks.clear();
    of.journal = {};
    of.ensemble = {};
    of.photographs.clear();
    of.removals.clear();
    std::erase_if(of.inputs,
                  [](const CaseInput& input) { return input.role == InputRole::Photograph || input.role == InputRole::Survey; });
    return of;
}

/// What a case says of its surveys.
std::vector<CaseInput> surveysOf(const Case& theCase) {
    std::vector<CaseInput> surveys;
    std::copy_if(theCase.inputs.begin(), theCase.inputs.end(), std::back_inserter(surveys),
                 [](const CaseInput& input) { return input.role == InputRole::Survey; });
    return surveys;
}

bool sameCauses(const CauseOrder& a, const CauseOrder& b) {
    const auto sameTime = [](const TimeEvidence& x, const TimeEvidence& y) { return x.name == y.name; };
    return a.files == b.files && std::equal(a.times.begin(), a.times.end(), b.times.begin(), b.times.end(), sameTime) &&
           a.photographs == b.photographs && a.photographed.photographs == b.photographed.photographs &&
           surveysOf(a.photographed) == surveysOf(b.photographed) && a.photographed.removals == b.photographed.removals &&
           std::equal(
               a.causes.begin(), a.causes.end(), b.causes.begin(), b.causes.end(), [](const StudyCase& x, const StudyCase& y) {
                   return x.name == y.name && x.base == y.base && x.scenario == y.scenario && bare(x.theCase) == bare(y.theCase);
               });
}

/// Why a photograph does not count; empty: it does.
QString whyLeftOut(const Photograph& photograph) {
    const bool drawn = std::any_of(photograph.masks.begin(), photograph.masks.end(),
                                   [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
    return !drawn                     ? CausesDisplay::tr("No outline of the debris is drawn on it.")
           : photograph.time          ? CausesDisplay::tr("It was not taken at rest: members keep their debris at rest.")
           : photograph.pairs.empty() ? CausesDisplay::tr("Its camera is not matched.")
                                      : QString();
}

QString kindWords(io::EvidenceFile::Kind kind) {
    using Kind = io::EvidenceFile::Kind;
    return kind == Kind::Footprint ? CausesDisplay::tr("footprint")
           : kind == Kind::Heights ? CausesDisplay::tr("heights")
                                   : CausesDisplay::tr("surface");
}

}  // namespace

CausesDisplay::CausesDisplay(Session& session, EnsembleDisplay& ensemble, widgets::CausesPanel& panel, widgets::CausesPage& page,
                             QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_work(session.part<StudyWork>()),
      m_ensemble(ensemble),
      m_panel(panel),
      m_page(page),
      m_kept(session.part<Kept>()) {
    m_panel.setBlind(m_kept.blind);
    connect(&m_work, &StudyWork::compared, this, [this](const std::shared_ptr<const MadeComparison>& made) {
        m_kept.answer.take(made);
        showPage();
    });
    connect(&m_work, &StudyWork::ended, this, &CausesDisplay::ended);
    connect(&m_work, &StudyWork::progressed, this, [this](const QString& what, double fraction, double left) {
        if (m_work.comparing()) {
            m_panel.setProgress(what, fraction, left);
        }
    });
    connectPanel();
    connect(&m_page, &widgets::CausesPage::saveTableRequested, this, &CausesDisplay::saveTable);
    connect(&m_page, &widgets::CausesPage::saveMapRequested, this, &CausesDisplay::saveMap);
    connect(&m_page, &widgets::CausesPage::saveChartRequested, this, &CausesDisplay::saveChartRequested);
    connect(&m_document, &Document::replaced, this, [this] {
        if (m_document.base() != m_kept.base) {
            m_kept.base = m_document.base();
            m_kept.added.clear();
            m_kept.files.clear();
            m_kept.times.clear();
            m_kept.unticked.clear();
            m_kept.answer.drop();
            showFailure({});
            if (m_work.comparing()) {
                m_work.forget();
                m_kept.answer.end();
            }
        }
        refresh();
    });
    for (const auto signal : {&Document::ensembleChanged, &Document::scenarioChanged, &Document::scenariosChanged,
                              &Document::photographsChanged, &Document::surveysChanged}) {
        connect(&m_document, signal, this, &CausesDisplay::refresh);
    }
    connect(&m_computation, &Computation::prepared, this, &CausesDisplay::refresh);
    connect(&m_computation, &Computation::stateChanged, this, [this] {
        // Progress comes many times a second.
        if (const bool simulating = m_computation.busy(Stage::Simulation); simulating != m_simulating) {
            m_simulating = simulating;
            showPanel();
        }
    });
    refresh();
    showFailure(m_kept.failure);
}

CausesDisplay::~CausesDisplay() {
    m_kept.blind = m_panel.blind();
}

void CausesDisplay::showFailure(const std::optional<Failure>& failure) {
    m_kept.failure = failure;
    m_panel.setError(failure ? failure->what() : QString(), failure ? failure->remedy() : QString());
}

void CausesDisplay::connectPanel() {
    using Kind = io::EvidenceFile::Kind;
    connect(&m_panel, &widgets::CausesPanel::addCausesRequested, this, &CausesDisplay::chooseCauses);
    connect(&m_panel, &widgets::CausesPanel::addFootprintRequested, this, [this] { chooseEvidence(Kind::Footprint); });
    connect(&m_panel, &widgets::CausesPanel::addHeightsRequested, this, [this] { chooseEvidence(Kind::Heights); });
    connect(&m_panel, &widgets::CausesPanel::addSurfaceRequested, this, [this] { chooseEvidence(Kind::Surface); });
    connect(&m_panel, &widgets::CausesPanel::timeTold, this, &CausesDisplay::addTime);
    connect(&m_panel, &widgets::CausesPanel::causeUsed, this, &CausesDisplay::setCauseUsed);
    connect(&m_panel, &widgets::CausesPanel::evidenceUsed, this, &CausesDisplay::setEvidenceUsed);
    connect(&m_panel, &widgets::CausesPanel::causeRemoved, this, [this](int cause) {
        const auto place = static_cast<std::size_t>(cause) - ownCauses().size();
        if (place < m_kept.added.size()) {
            m_kept.added.erase(m_kept.added.begin() + static_cast<std::ptrdiff_t>(place));
            refresh();
        }
    });
    connect(&m_panel, &widgets::CausesPanel::evidenceRemoved, this, [this](int evidence) {
        const auto place = static_cast<std::size_t>(evidence) - m_document.theCase().photographs.size();
        const std::size_t timed = place - m_kept.files.size();
        if (place < m_kept.files.size()) {
            m_kept.files.erase(m_kept.files.begin() + static_cast<std::ptrdiff_t>(place));
            refresh();
        } else if (timed < m_kept.times.size()) {
            m_kept.times.erase(m_kept.times.begin() + static_cast<std::ptrdiff_t>(timed));
            refresh();
        }
    });
    connect(&m_panel, &widgets::CausesPanel::compareRequested, this, &CausesDisplay::compare);
    connect(&m_panel, &widgets::CausesPanel::cancelRequested, &m_work, &StudyWork::cancel);
}

void CausesDisplay::chooseCauses() {
    const QStringList paths =
        QFileDialog::getOpenFileNames(m_page.window(), tr("Cases of the same site"), QFileInfo(m_document.base()).absolutePath(),
                                      tr("Cases and FE results (*);;Cases (*.rubble)"));
    if (!paths.isEmpty()) {
        addCauses(paths);
    }
}

void CausesDisplay::addCauses(const QStringList& paths) {
    showFailure({});
    for (const QString& path : paths) {
        const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
        try {
            Added added;
            added.path = QString::fromStdString(file);
            const bool isCase = io::isCaseFile(file);
            added.plain = !isCase;
            added.cause.base = isCase ? file : file + ".rubble";
            added.cause.theCase = isCase ? io::loadCase(file) : io::caseForFe(file, added.cause.base);
            added.cause.name = added.cause.theCase.title;
            for (int n = 2; std::any_of(m_kept.added.begin(), m_kept.added.end(),
                                        [&](const Added& each) { return each.cause.name == added.cause.name; });
                 ++n) {
                added.cause.name = added.cause.theCase.title + " (" + std::to_string(n) + ")";
            }
            const bool known =
                std::any_of(m_kept.added.begin(), m_kept.added.end(), [&](const Added& each) { return each.path == added.path; });
            if (!known) {
                m_kept.added.push_back(std::move(added));
            }
        } catch (...) {
            showFailure(failureOf(std::current_exception()));
        }
    }
    refresh();
}

void CausesDisplay::chooseEvidence(io::EvidenceFile::Kind kind) {
    const bool polygons = kind == io::EvidenceFile::Kind::Footprint;
    const QStringList paths =
        QFileDialog::getOpenFileNames(m_page.window(), polygons ? tr("Footprint of the debris") : tr("Heights that were surveyed"),
                                      QFileInfo(m_document.base()).absolutePath(),
                                      polygons ? tr("Polygons (*.gpkg *.geojson *.json *.shp);;All files (*)")
                                               : tr("Rasters (*.tif *.tiff *.asc *.vrt);;All files (*)"));
    if (!paths.isEmpty()) {
        addEvidence(kind, paths);
    }
}

void CausesDisplay::addEvidence(io::EvidenceFile::Kind kind, const QStringList& paths) {
    for (const QString& path : paths) {
        const io::EvidenceFile file{kind, QFileInfo(path).absoluteFilePath().toStdString()};
        if (std::none_of(m_kept.files.begin(), m_kept.files.end(), [&](const File& each) { return each.file == file; })) {
            m_kept.files.push_back({file, true});
        }
    }
    refresh();
}

void CausesDisplay::addTime(const TimeEvidence& time) {
    const auto known = [&](const Timed& each) { return each.time.name == time.name; };
    if (std::none_of(m_kept.times.begin(), m_kept.times.end(), known)) {
        m_kept.times.push_back({time, true});
    }
    refresh();
}

void CausesDisplay::addEvidence(const QStringList& named) {
    using Kind = io::EvidenceFile::Kind;
    for (const QString& each : named) {
        for (const Kind kind : {Kind::Footprint, Kind::Heights, Kind::Surface}) {
            if (each.section(u'=', 0, 0).toStdString() == io::evidenceKeyword(kind)) {
                addEvidence(kind, {each.section(u'=', 1)});
            }
        }
    }
}

void CausesDisplay::setCauseUsed(int cause, bool used) {
    const std::vector<StudyCase> own = ownCauses();
    const auto place = static_cast<std::size_t>(cause);
    if (place < own.size()) {
        const std::string id = "cause " + own[place].scenario.value_or("");
        used ? static_cast<void>(m_kept.unticked.erase(id)) : static_cast<void>(m_kept.unticked.insert(id));
    } else if (place - own.size() < m_kept.added.size()) {
        m_kept.added[place - own.size()].used = used;
    }
    refresh();
}

void CausesDisplay::setEvidenceUsed(int evidence, bool used) {
    const auto& photographs = m_document.theCase().photographs;
    const auto place = static_cast<std::size_t>(evidence);
    if (place < photographs.size()) {
        const std::string id = "photograph " + photographs[place].input;
        used ? static_cast<void>(m_kept.unticked.erase(id)) : static_cast<void>(m_kept.unticked.insert(id));
    } else if (place - photographs.size() < m_kept.files.size()) {
        m_kept.files[place - photographs.size()].used = used;
    } else if (const std::size_t timed = place - photographs.size() - m_kept.files.size(); timed < m_kept.times.size()) {
        m_kept.times[timed].used = used;
    }
    refresh();
}

std::vector<StudyCase> CausesDisplay::ownCauses() const {
    std::vector<StudyCase> causes;
    const Case& theCase = m_document.theCase();
    const std::string base = m_document.base().toStdString();
    for (const CaseScenario& scenario : theCase.scenarios) {
        causes.push_back({theCase.scenarios.size() > 1 ? scenario.name : theCase.title, theCase, base, scenario.id});
    }
    return causes;
}

StudyCase CausesDisplay::asOpen(const Added& result) const {
    StudyCase cause{result.cause.name, m_document.theCase(), m_document.base().toStdString(), std::nullopt};
    const CaseScenario* active = m_document.active();
    if (active == nullptr) {
        return result.cause;
    }
    cause.scenario = active->id;
    cause.theCase.scenarios = {*active};
    const CaseInput* replaced = findFeInput(cause.theCase, *active);
    for (CaseInput& input : cause.theCase.inputs) {
        if (&input == replaced) {
            input.path = result.path.toStdString();
            input.sha256.clear();
        }
    }
    return cause;
}

CauseOrder CausesDisplay::causeOrder() const {
    CauseOrder order;
    for (const StudyCase& cause : ownCauses()) {
        if (!m_kept.unticked.contains("cause " + *cause.scenario)) {
            order.causes.push_back(cause);
        }
    }
    for (const Added& added : m_kept.added) {
        if (added.used) {
            order.causes.push_back(added.plain ? asOpen(added) : added.cause);
        }
    }
    for (const File& file : m_kept.files) {
        if (file.used) {
            order.files.push_back(file.file);
        }
    }
    for (const Timed& time : m_kept.times) {
        if (time.used) {
            order.times.push_back(time.time);
        }
    }
    order.photographed = m_document.theCase();
    order.base = m_document.base().toStdString();
    for (const Photograph& photograph : order.photographed.photographs) {
        if (whyLeftOut(photograph).isEmpty() && !m_kept.unticked.contains("photograph " + photograph.input)) {
            order.photographs.push_back(photograph.input);
        }
    }
    order.blind = m_panel.blind();
    return order;
}

StudyOrder CausesDisplay::studyOrder() const {
    StudyOrder order = m_ensemble.order();
    // Causes are what is compared, not what is drawn.
    std::erase_if(order.settings.varied, [](const VariedSetting& varied) { return varied.key == scenarioKey; });
    return order;
}

QString CausesDisplay::whyNot(const CauseOrder& order) const {
    if (m_document.empty() || m_computation.inputs().fe == nullptr) {
        return tr("Open a result first.");
    }
    if (order.causes.size() < 2) {
        return tr("Tick two causes at least: scenarios of this case, or other cases of the site.");
    }
    if (m_computation.busy(Stage::Simulation)) {
        return tr("A run is being simulated: wait for it or cancel it.");
    }
    if (m_work.simulating()) {
        return tr("An ensemble is being simulated: wait for it or cancel it.");
    }
    return m_work.comparing() ? QString() : m_busy;
}

void CausesDisplay::compare() {
    const Compared now{causeOrder(), studyOrder()};
    if (!whyNot(now.causes).isEmpty() || m_work.running()) {
        return;
    }
    showFailure({});
    m_kept.answer.ask(now);
    m_panel.setProgress(tr("Preparing"), 0.0, std::numeric_limits<double>::quiet_NaN());
    m_work.compare(now.causes, now.study);
    refresh();
}

void CausesDisplay::ended(const Failure* failure) {
    if (!m_kept.answer.running()) {
        return;
    }
    m_kept.answer.end();
    if (failure != nullptr) {
        showFailure(*failure);
    } else if (made() != nullptr) {
        m_session.tell(tr("Causes compared"));
    }
    refresh();
}

void CausesDisplay::setBusy(const QString& why) {
    if (why != m_busy) {
        m_busy = why;
        showPanel();
    }
}

bool CausesDisplay::Compared::operator==(const Compared& other) const {
    return sameCauses(causes, other.causes) && study.settings == other.study.settings && study.surface == other.study.surface &&
           study.instant == other.study.instant;
}

bool CausesDisplay::stale() const {
    return m_kept.answer.stale({causeOrder(), studyOrder()});
}

void CausesDisplay::refresh() {
    showPanel();
    showPage();
}

void CausesDisplay::showPanel() {
    const CauseOrder order = causeOrder();
    widgets::CausesPanel::Content content;
    for (const StudyCase& cause : ownCauses()) {
        content.causes.push_back({QString::fromStdString(cause.name), tr("A scenario of this case"),
                                  !m_kept.unticked.contains("cause " + *cause.scenario), true, false});
    }
    for (const Added& added : m_kept.added) {
        content.causes.push_back({QString::fromStdString(added.cause.name), added.path, added.used, true, true});
    }
    const Case& theCase = m_document.theCase();
    for (const Photograph& photograph : theCase.photographs) {
        const auto input = std::find_if(theCase.inputs.begin(), theCase.inputs.end(),
                                        [&](const CaseInput& each) { return each.id == photograph.input; });
        const QString name = input != theCase.inputs.end() ? QFileInfo(QString::fromStdString(input->path)).fileName() : QString();
        const QString why = whyLeftOut(photograph);
        content.evidence.push_back({tr("photograph: %1").arg(name),
                                    why.isEmpty() ? tr("A photograph of this case, taken at rest") : why,
                                    !m_kept.unticked.contains("photograph " + photograph.input), why.isEmpty(), false});
    }
    for (const File& file : m_kept.files) {
        const QString path = QString::fromStdString(file.file.path);
        content.evidence.push_back(
            {QStringLiteral("%1: %2").arg(kindWords(file.file.kind), QFileInfo(path).fileName()), path, file.used, true, true});
    }
    for (const Timed& each : m_kept.times) {
        const TimeEvidence& time = each.time;
        const QString name = tr("%1 at %2, %3")
                                 .arg(widgets::shownWith(time.time, "s", 4), widgets::shownIn(time.place.x(), "m"),
                                      widgets::shownWith(time.place.y(), "m"));
        content.evidence.push_back({name,
                                    tr("Debris came within %1 of this place so long after the first debris that came down "
                                       "anywhere, give or take %2")
                                        .arg(widgets::shownLength(time.radius), widgets::shownWith(time.accuracy, "s")),
                                    each.used, true, true});
    }
    content.available = !m_document.empty();
    content.running = m_work.comparing();
    content.why = whyNot(order);
    content.ready = content.why.isEmpty() && !m_work.running();
    const EnsembleSettings& ensemble = theCase.ensemble;
    if (content.available) {
        content.members = tr("Each gets %1 members with what is varied under Ensemble.").arg(widgets::shownCount(ensemble.members));
    }
    if (made() != nullptr) {
        content.findings = made()->findings;
    }
    m_panel.setContent(content);
}

void CausesDisplay::showPage() {
    widgets::CausesPage::Content content;
    if (made() != nullptr) {
        content.comparison = made()->comparison;
        content.blind = made()->blind;
        content.further = made()->further;
        content.causes = made()->causes;
        if (made()->comparison != nullptr && made()->comparison->separation) {
            content.separation = std::shared_ptr<const DebrisMap>(made()->comparison, &*made()->comparison->separation);
            const Hypothesis& closest = made()->hypotheses[made()->comparison->ranking.causes.front().hypothesis];
            content.place = pictureStyle(
                io::ensembleOrigin(*closest.ensemble, *content.separation, made()->frame, made()->site, made()->inputs));
        }
        content.stale = stale();
    }
    m_page.setContent(content);
}

void CausesDisplay::saveTable() {
    const QString path = QFileDialog::getSaveFileName(m_page.window(), tr("Ranking of the causes"),
                                                      QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/causes.csv"),
                                                      tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveTableTo(path);
    }
}

void CausesDisplay::saveTableTo(const QString& path) {
    if (made() == nullptr || made()->comparison == nullptr) {
        return;
    }
    m_session.writeNow(path, [&] {
        io::writeAtomically(path.toStdString(), [&](std::ostream& out) { writeRankingCsv(*made()->comparison, out); });
    });
}

void CausesDisplay::saveMap() {
    const QString path =
        QFileDialog::getSaveFileName(m_page.window(), tr("Map of what tells causes apart"),
                                     QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/separation.tif"),
                                     tr("GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveMapTo(path);
    }
}

void CausesDisplay::saveMapTo(const QString& path) {
    if (made() == nullptr || made()->comparison == nullptr || !made()->comparison->separation) {
        return;
    }
    m_computation.write(
        [path, made = made()](const Execution& execution) {
            const Hypothesis& closest = made->hypotheses[made->comparison->ranking.causes.front().hypothesis];
            const DebrisMap& map = *made->comparison->separation;
            writeMapFile(path, map, MapLayer::Separation,
                         io::ensembleOrigin(*closest.ensemble, map, made->frame, made->site, made->inputs), execution);
        },
        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

}  // namespace rubble
