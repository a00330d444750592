#include "app/gui/evidence/causes_display.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <iterator>

#include "app/gui/evidence/cause_choice.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/evidence/map_export.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "core/evidence/ensembles/study_tables.h"
#include "io/base/files.h"
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
      m_choice(session.part<CauseChoice>()),
      m_kept(session.part<Kept>()) {
    m_panel.setBlind(m_choice.blind());
    connect(&m_choice, &CauseChoice::changed, this, &CausesDisplay::refresh);
    connect(&m_choice, &CauseChoice::replaced, this, [this] { m_panel.setBlind(m_choice.blind()); });
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
    connect(&m_panel, &widgets::CausesPanel::timeTold, this, [this](const TimeEvidence& time) {
        m_choice.addTime(time);
        chosen();
    });
    connect(&m_panel, &widgets::CausesPanel::blindChosen, this, [this](bool blind) {
        m_choice.setBlind(blind);
        chosen();
    });
    const auto ticks = [this](auto signal, auto use) {
        connect(&m_panel, signal, this, [this, use](int row, bool used) {
            (m_choice.*use)(static_cast<std::size_t>(row), used);
            chosen();
        });
    };
    ticks(&widgets::CausesPanel::causeUsed, &CauseChoice::useCause);
    ticks(&widgets::CausesPanel::evidenceUsed, &CauseChoice::useEvidence);
    const auto removes = [this](auto signal, auto remove) {
        connect(&m_panel, signal, this, [this, remove](int row) {
            (m_choice.*remove)(static_cast<std::size_t>(row));
            chosen();
        });
    };
    removes(&widgets::CausesPanel::causeRemoved, &CauseChoice::removeCause);
    removes(&widgets::CausesPanel::evidenceRemoved, &CauseChoice::removeEvidence);
    connect(&m_panel, &widgets::CausesPanel::compareRequested, this, &CausesDisplay::compare);
    connect(&m_panel, &widgets::CausesPanel::cancelRequested, &m_work, &StudyWork::cancel);
}

void CausesDisplay::chooseCauses() {
    const QStringList paths =
        QFileDialog::getOpenFileNames(m_page.window(), tr("Cases of the same site"), QFileInfo(m_document.base()).absolutePath(),
                                      tr("Cases and FE results (*);;Cases (*.rubble)"));
    if (!paths.isEmpty()) {
        addCauses(paths);
        chosen();
    }
}

void CausesDisplay::addCauses(const QStringList& paths) {
    showFailure({});
    for (const QString& path : paths) {
        try {
            m_choice.addCause(path);
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
        chosen();
    }
}

void CausesDisplay::addEvidence(io::EvidenceFile::Kind kind, const QStringList& paths) {
    for (const QString& path : paths) {
        m_choice.addFile({kind, QFileInfo(path).absoluteFilePath().toStdString()});
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

void CausesDisplay::chosen() {
    m_choice.keep();
    refresh();
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
    const Compared now{m_choice.order(), studyOrder()};
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
    return m_kept.answer.stale({m_choice.order(), studyOrder()});
}

void CausesDisplay::refresh() {
    showPanel();
    showPage();
}

void CausesDisplay::showPanel() {
    const CauseOrder order = m_choice.order();
    widgets::CausesPanel::Content content;
    const auto entryOf = [](const QString& name, const QString& tip, const QString& why, bool used, bool removable) {
        return widgets::CausesPanel::Entry{name, why.isEmpty() ? tip : why, used, why.isEmpty(), removable};
    };
    for (const CauseChoice::Cause& cause : m_choice.causes()) {
        content.causes.push_back(
            entryOf(QString::fromStdString(cause.study.name), cause.where, cause.why, cause.used, cause.added));
    }
    for (const CauseChoice::Evidence& each : m_choice.evidence()) {
        content.evidence.push_back(entryOf(each.name, each.tip, each.why, each.used, each.input.empty()));
    }
    content.available = !m_document.empty();
    content.running = m_work.comparing();
    content.why = whyNot(order);
    content.ready = content.why.isEmpty() && !m_work.running();
    const EnsembleSettings& ensemble = m_document.theCase().ensemble;
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
            content.place = pictureStyle(io::separationOrigin(made()->hypotheses, *content.separation, made()->basis),
                                         io::separationCautions(made()->hypotheses, made()->basis));
        }
        content.stale = stale();
    }
    m_page.setContent(content);
}

void CausesDisplay::saveTable() {
    const QString path =
        askSavePath(m_page.window(), tr("Ranking of the causes"),
                    QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/causes.csv"), tr("Tables (*.csv)"));
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
    const QString path = askSavePath(m_page.window(), tr("Map of what tells causes apart"),
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
            const DebrisMap& map = *made->comparison->separation;
            std::optional<figures::MapRing> ring;
            if (const auto& place = made->comparison->place) {
                ring = figures::MapRing{place->middle, place->radius()};
            }
            writeMapFile(path, map, MapLayer::Separation, io::separationOrigin(made->hypotheses, map, made->basis),
                         io::separationCautions(made->hypotheses, made->basis), execution, ring);
        },
        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

}  // namespace rubble
