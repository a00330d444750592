#include "app/gui/evidence/survey_display.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/evidence/survey_reach.h"
#include "app/gui/evidence/survey_sections.h"
#include "app/gui/evidence/surveys/cloud_placing.h"
#include "app/gui/evidence/surveys/survey_pairs.h"
#include "app/gui/evidence/surveys/survey_reading.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/no_evidence.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/exports/provenance.h"
#include "io/exports/survey_files.h"
#include "io/run/run_cautions.h"
#include "io/site/input_files.h"
#include "io/site/site_place.h"
#include "io/site/surveys/evidence_origin.h"
#include "io/site/surveys/survey_registration.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_place.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/evidence/surveys/removal_box.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/survey_picture.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

/// All places whose debris was removed at any time.
Outline removedPlaces(const Case& theCase) {
    Outline all;
    for (const Removal& removal : theCase.removals) {
        all.polygons.insert(all.polygons.end(), removal.area.polygons.begin(), removal.area.polygons.end());
    }
    return all;
}

}  // namespace

SurveyDisplay::SurveyDisplay(Session& session, PanelDeck& deck, widgets::EvidencePage& page, Actions& actions, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_page(page),
      m_work(session.part<SurveyWork>()),
      m_reach(session.part<SurveyReach>()),
      m_sections(new SurveySections(session, page, this)) {
    m_pairs = new SurveyPairs(
        session, page,
        [this](const std::string& id, const PairFit& fit) {
            place(id, fit.registration, [] { return tr("survey placed by pairs"); });
        },
        this);
    m_fit = new CloudPlacing(
        session, page,
        [this](const std::string& id, const Registration& fitted) {
            place(id, fitted, [] { return tr("cloud fitted to what did not move"); });
        },
        this);
    m_reading = new SurveyReading(
        session, deck, page.window(), [this] { return current(); },
        [this](const CaseInput& read) {
            edit(
                [&](CaseInput& input) {
                    input.read = read.read;
                    input.kind = read.kind;
                },
                [] { return tr("how the survey is read"); });
        },
        this);
    connect(&actions[ActionId::AddSurvey], &QAction::triggered, this, &SurveyDisplay::chooseFile);
    connect(&actions[ActionId::CompareSurvey], &QAction::triggered, this, [this] {
        m_deck.choose(PanelDeck::Evidence);
        compare();
    });
    widgets::SurveyBox& box = deck.evidence().survey();
    const auto takeSettings = [this, &box] {
        box.setSettings(surveySettingsOf(m_document.theCase()));
        refresh();
    };
    connect(&m_document, &Document::evidenceChanged, this, takeSettings);
    connect(&m_document, &Document::replaced, this, takeSettings);
    box.setSettings(surveySettingsOf(m_document.theCase()));
    connect(&box, &widgets::SurveyBox::addRequested, this, &SurveyDisplay::chooseFile);
    connect(&box, &widgets::SurveyBox::removeRequested, this, &SurveyDisplay::remove);
    connect(&box, &widgets::SurveyBox::compareRequested, this, &SurveyDisplay::compare);
    connect(&box, &widgets::SurveyBox::cancelRequested, this, &SurveyDisplay::cancel);
    connect(&box, &widgets::SurveyBox::saveRequested, this, &SurveyDisplay::save);
    connect(&box, &widgets::SurveyBox::settingsChanged, this, [this, &box] {
        const SurveySettings asked = box.settings();
        EvidenceSettings evidence = m_document.theCase().evidence;
        evidence.cell = asked.cell;
        evidence.leastHeight = asked.leastHeight;
        evidence.fit = asked.fit;
        evidence.surveysWithFallen = asked.withFallen;
        m_document.setEvidence(evidence, [] { return tr("how surveys are compared"); });
        refresh();
    });
    connect(&box, &widgets::SurveyBox::showsFallenChosen, this, &SurveyDisplay::setShowsFallen);
    connect(&box, &widgets::SurveyBox::chosen, this, [this](int survey) {
        m_work.chosen = survey;
        refresh();
    });
    connect(&box, &widgets::SurveyBox::scopeDrawRequested, this, [this](ScopePart part) {
        draw(part == ScopePart::Area ? widgets::SurveyView::Draws::Area : widgets::SurveyView::Draws::LeftOut);
    });
    connect(&box, &widgets::SurveyBox::sectionRequested, this, &SurveyDisplay::startSection);
    connect(&box, &widgets::SurveyBox::scopeFileRequested, this, &SurveyDisplay::chooseScope);
    connect(&box, &widgets::SurveyBox::scopeRemoved, this, [this](ScopePart part, int polygon) {
        edit(
            [&](CaseInput& input) {
                std::vector<OutlinePolygon>& polygons = input.scope.part(part).polygons;
                if (polygon >= 0 && polygon < static_cast<int>(polygons.size())) {
                    polygons.erase(polygons.begin() + polygon);
                }
            },
            [part] { return part == ScopePart::Area ? tr("area of interest removed") : tr("left-out polygon removed"); });
    });
    connect(&box, &widgets::SurveyBox::noiseChosen, this, [this](const widgets::SurveyBox::Errors& errors) {
        edit(
            [&](CaseInput& input) {
                input.noise = errors.noise;
                input.groundNoise = errors.groundNoise;
                input.offsetError = errors.offset;
            },
            [] { return tr("noise of the survey"); });
    });
    connectPlace();
    connectRemovals();
    connectMap();
    connect(&m_work, &SurveyWork::changed, this, &SurveyDisplay::refresh);
    connect(&m_work, &SurveyWork::compared, this, [this] { m_page.showSurvey(true); });
    connect(&m_reach, &SurveyReach::changed, this, &SurveyDisplay::refresh);
    connect(&m_document, &Document::inputsAccepted, this, &SurveyDisplay::refresh);
    connect(&m_document, &Document::surveysChanged, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runBegun, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runReopened, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::prepared, this, &SurveyDisplay::refresh);
    refresh();
    m_page.showSurvey(m_work.shown && m_work.answer.result() != nullptr);
}

void SurveyDisplay::connectMap() {
    connect(&m_page.survey(), &widgets::SurveyView::drawn, this, &SurveyDisplay::take);
    connect(m_sections, &SurveySections::changed, this,
            [this] { m_page.survey().setMarked(removedPlaces(m_document.theCase()), m_sections->line()); });
}

void SurveyDisplay::take(widgets::SurveyView::Draws what, const OutlineRing& ring) {
    using Draws = widgets::SurveyView::Draws;
    if (what == Draws::Section) {
        if (const CaseInput* survey = current(); survey != nullptr && m_work.answer.result() != nullptr && !stale()) {
            m_sections->cut(ring, *survey, m_work.answer.result());
        }
    } else if (what == Draws::Removed) {
        addRemoval({"drawn", m_removedSince, {{{ring}}}});
    } else {
        const ScopePart part = what == Draws::Area ? ScopePart::Area : ScopePart::LeftOut;
        edit([&](CaseInput& input) { input.scope.part(part).polygons.push_back({ring}); },
             [part] { return part == ScopePart::Area ? tr("area of interest drawn") : tr("left-out polygon drawn"); });
    }
}

void SurveyDisplay::connectRemovals() {
    widgets::RemovalBox& box = m_deck.evidence().survey().removals();
    connect(&box, &widgets::RemovalBox::drawRequested, this, [this](const std::string& since) {
        m_removedSince = since;
        draw(widgets::SurveyView::Draws::Removed);
    });
    connect(&box, &widgets::RemovalBox::fileRequested, this, &SurveyDisplay::chooseRemoval);
    connect(&box, &widgets::RemovalBox::timeChosen, this, [this](int removal, const std::string& since) {
        editRemovals([&](std::vector<Removal>& all) { all.at(static_cast<std::size_t>(removal)).time = since; },
                     [] { return tr("when debris was removed"); });
    });
    connect(&box, &widgets::RemovalBox::removeRequested, this, [this](int removal) {
        editRemovals([&](std::vector<Removal>& all) { all.erase(all.begin() + removal); }, [] { return tr("removal left out"); });
    });
}

void SurveyDisplay::editRemovals(const std::function<void(std::vector<Removal>&)>& change, const widgets::Wording& what) {
    std::vector<Removal> removals = m_document.theCase().removals;
    change(removals);
    m_document.setRemovals(std::move(removals), what);
}

void SurveyDisplay::addRemoval(Removal removal) {
    editRemovals([&](std::vector<Removal>& all) { all.push_back(std::move(removal)); }, [] { return tr("removed debris added"); });
}

void SurveyDisplay::chooseRemoval(const std::string& since) {
    const QString path = QFileDialog::getOpenFileName(m_page.window(), tr("What was removed"),
                                                      QFileInfo(m_document.base()).absolutePath(), polygonFileKinds());
    if (!path.isEmpty()) {
        addRemovalOf(since, path);
    }
}

void SurveyDisplay::addRemovalOf(const std::string& since, const QString& path) {
    readPolygons(path, [&](Outline read) { addRemoval({QFileInfo(path).fileName().toStdString(), since, std::move(read)}); });
}

void SurveyDisplay::place(const std::string& id, const Registration& registration, const widgets::Wording& what) {
    choose(id);
    if (current() != nullptr && current()->id == id) {
        edit([&](CaseInput& input) { input.registration = registration; }, what);
    }
}

void SurveyDisplay::connectPlace() {
    widgets::SurveyPlace& place = m_deck.evidence().survey().place();
    connect(&place, &widgets::SurveyPlace::edited, this, [this](const widgets::SurveyPlace::Stated& stated) {
        edit(
            [&](CaseInput& input) {
                input.taken = stated.taken;
                input.before = stated.before;
                input.instant = stated.instant;
            },
            [] { return tr("when the survey was taken"); });
    });
    connect(&place, &widgets::SurveyPlace::pickRequested, this, [this] {
        if (const CaseInput* survey = current(); survey != nullptr) {
            m_pairs->pick(*survey);
        }
    });
    connect(&place, &widgets::SurveyPlace::fitRequested, this, [this] {
        if (const CaseInput* survey = current(); survey != nullptr) {
            m_fit->open(*survey);
        }
    });
    connect(&place, &widgets::SurveyPlace::pairsRequested, this, &SurveyDisplay::choosePairs);
    connect(&place, &widgets::SurveyPlace::unplaceRequested, this,
            [this] { edit([](CaseInput& input) { input.registration.reset(); }, [] { return tr("survey unplaced"); }); });
}

SurveyDisplay::~SurveyDisplay() {
    m_work.shown = m_page.surveyShown();
}

std::vector<const CaseInput*> SurveyDisplay::surveys() const {
    std::vector<const CaseInput*> found;
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role == InputRole::Survey) {
            found.push_back(&input);
        }
    }
    return found;
}

const CaseInput* SurveyDisplay::current() const {
    const auto all = surveys();
    return m_work.chosen >= 0 && m_work.chosen < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(m_work.chosen)]
                                                                              : nullptr;
}

void SurveyDisplay::choose(const std::string& id) {
    const auto all = surveys();
    const auto found = std::find_if(all.begin(), all.end(), [&](const CaseInput* survey) { return survey->id == id; });
    if (found != all.end() && m_work.chosen != static_cast<int>(found - all.begin())) {
        m_work.chosen = static_cast<int>(found - all.begin());
        refresh();
    }
}

void SurveyDisplay::choosePairs() {
    const QString path =
        QFileDialog::getOpenFileName(m_page.window(), tr("Pairs of places"), QFileInfo(m_document.base()).absolutePath(),
                                     tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
    if (!path.isEmpty()) {
        placeByPairs(path);
    }
}

void SurveyDisplay::placeByPairs(const QString& path) {
    const CaseInput* survey = current();
    const Inputs& inputs = m_computation.inputs();
    if (survey == nullptr || inputs.fe == nullptr) {
        m_session.tell(tr("There is no survey to place, or the FE result is not open."));
        return;
    }
    io::PairsRequest request;
    request.survey = io::inputPath(m_document.base().toStdString(), *survey);
    request.table = path.toStdString();
    request.read = survey->read;
    request.control = m_deck.evidence().survey().place().control();
    request.frame = inputs.frame;
    request.site = m_document.theCase().site;
    request.around = io::boundsAtRest(inputs.fe->mesh());
    try {
        const PairFit fit = io::placeByPairs(request);
        edit([&](CaseInput& input) { input.registration = fit.registration; }, [] { return tr("survey placed by pairs"); });
        if (!fit.findings.empty()) {
            m_session.tell(widgets::worded(fit.findings.list().front().what));
        }
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.tell(failure->inOneLine());
    }
}

void SurveyDisplay::chooseFile() {
    if (m_document.empty()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(m_page.window(), tr("Add a survey"),
                                                      QFileInfo(m_document.base()).absolutePath(), surveyFileKinds());
    if (!path.isEmpty()) {
        add(path);
    }
}

void SurveyDisplay::add(const QString& path) {
    Case theCase = m_document.theCase();
    try {
        const std::size_t added = io::takeSurvey(theCase, m_document.base().toStdString(), path.toStdString());
        if (!m_reading->ask(theCase.inputs[added], path)) {
            return;
        }
        // One that the case has already is worked on where it stands.
        m_work.chosen =
            static_cast<int>(std::count_if(theCase.inputs.begin(), theCase.inputs.begin() + static_cast<std::ptrdiff_t>(added),
                                           [](const CaseInput& input) { return input.role == InputRole::Survey; }));
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.tell(failure->inOneLine());
        return;
    }
    m_deck.choose(PanelDeck::Evidence);
    m_document.setSurveys(std::move(theCase.inputs),
                          [name = QFileInfo(path).fileName()] { return tr("survey %1 added").arg(name); });
}

void SurveyDisplay::remove() {
    if (const CaseInput* survey = current(); survey != nullptr) {
        std::vector<CaseInput> inputs = m_document.theCase().inputs;
        std::erase_if(inputs, [id = survey->id](const CaseInput& input) { return input.id == id; });
        m_work.chosen = std::max(0, m_work.chosen - 1);
        m_document.setSurveys(std::move(inputs), [] { return tr("survey removed"); });
    }
}

void SurveyDisplay::edit(const std::function<void(CaseInput&)>& change, const widgets::Wording& what) {
    if (const CaseInput* survey = current(); survey != nullptr) {
        std::vector<CaseInput> inputs = m_document.theCase().inputs;
        for (CaseInput& input : inputs) {
            if (input.id == survey->id) {
                change(input);
            }
        }
        m_document.setSurveys(std::move(inputs), what);
    }
}

void SurveyDisplay::setShowsFallen(std::optional<bool> shows) {
    edit([&](CaseInput& input) { input.showsFallen = shows; }, [] { return tr("what the survey shows"); });
}

void SurveyDisplay::draw(widgets::SurveyView::Draws what) {
    if (comparison() == nullptr) {
        m_session.tell(tr("Compare once, then draw on the difference map."));
        return;
    }
    m_page.showSurvey(true);
    m_page.survey().draw(what);
}

bool SurveyDisplay::cutsAlong() const {
    const CaseInput* survey = current();
    return survey != nullptr && evidenceFormOf(*survey) == EvidenceForm::Measured && survey->held == PointsHeld::Section;
}

void SurveyDisplay::startSection() {
    const bool drawn = comparison() != nullptr && current() != nullptr && m_work.answer.answered().survey.id == current()->id;
    if (cutsAlong() && !drawn) {
        m_sections->cutAlong(*current());
    } else {
        draw(widgets::SurveyView::Draws::Section);
    }
}

void SurveyDisplay::chooseScope(ScopePart part) {
    const QString path =
        QFileDialog::getOpenFileName(m_page.window(), part == ScopePart::Area ? tr("Area of interest") : tr("What is left out"),
                                     QFileInfo(m_document.base()).absolutePath(), polygonFileKinds());
    if (!path.isEmpty()) {
        addScope(part, path);
    }
}

void SurveyDisplay::readPolygons(const QString& path, const std::function<void(Outline)>& take) {
    try {
        Findings said;
        take(io::readScope(path.toStdString(), m_document.theCase().frame, m_document.theCase().site, said, Execution()));
        if (!said.empty()) {
            m_session.tell(widgets::worded(said.list().front().what));
        }
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.tell(failure->inOneLine());
    }
}

void SurveyDisplay::addScope(ScopePart part, const QString& path) {
    readPolygons(path, [&](const Outline& read) {
        edit(
            [&](CaseInput& input) {
                std::vector<OutlinePolygon>& polygons = input.scope.part(part).polygons;
                polygons.insert(polygons.end(), read.polygons.begin(), read.polygons.end());
            },
            [part] { return part == ScopePart::Area ? tr("area of interest added") : tr("left-out polygons added"); });
    });
}

std::shared_ptr<const SurveyComparison> SurveyDisplay::comparison() const {
    const std::shared_ptr<const SurveyWork::Made>& made = m_work.answer.result();
    return made != nullptr ? std::shared_ptr<const SurveyComparison>(made, &made->comparison) : nullptr;
}

SurveyWork::Compared SurveyDisplay::comparedNow(const CaseInput& survey, const RunRecord& record) const {
    SurveyWork::Compared now{survey, record.reader.get(), m_deck.evidence().survey().settings()};
    takeStated(now.settings, m_document.theCase(), survey, now.said);
    now.said.append(sameEvidence(m_document.theCase(), survey.id));
    now.origin = record.reader != nullptr ? record.reader->origin() : io::RunOrigin();
    return now;
}

bool SurveyDisplay::stale() const {
    const RunRecord* record = m_computation.currentRun();
    const CaseInput* survey = current();
    return record == nullptr || survey == nullptr || m_work.answer.stale(comparedNow(*survey, *record)) ||
           m_computation.runStale(m_document.scenario());
}

QString SurveyDisplay::whyNoComparison() const {
    const CaseInput* survey = current();
    if (survey != nullptr && survey->held == PointsHeld::Control) {
        return tr("Points that are held as control show no debris: they name places for pairs of photographs.");
    }
    if (survey != nullptr && !hasOverlap(*survey)) {
        return tr(
            "Points that are held for sections have no surface to compare: cut a section along them, or hold them as the edge "
            "of the debris.");
    }
    return EvidenceWork::whyNoDebris(m_computation.currentRun());
}

void SurveyDisplay::compare() {
    const CaseInput* survey = current();
    if (survey == nullptr || !whyNoComparison().isEmpty() || busy()) {
        return;
    }
    const RunRecord* record = m_computation.currentRun();
    m_work.start(comparedNow(*survey, *record), EvidenceRun(m_computation.inputs(), record), m_document.theCase(),
                 m_computation.inputs().frame, io::inputPath(m_document.base().toStdString(), *survey));
}

void SurveyDisplay::cancel() {
    m_work.cancel();
}

/// Whether what would be saved is there; says so where it is not.
bool SurveyDisplay::savable() {
    const RunRecord* record = m_computation.currentRun();
    const bool there = m_work.answer.result() != nullptr && record != nullptr && record->reader != nullptr && !stale();
    if (!there) {
        m_session.tell(tr("The comparison is of another run or other settings.") + u' ' + tr("Compare again, then save."));
    }
    return there;
}

void SurveyDisplay::save() {
    if (!savable()) {
        return;
    }
    const QString path = askSavePath(m_page.window(), tr("Difference map"),
                                     QFileInfo(m_document.base()).absolutePath() + u'/' +
                                         QFileInfo(m_document.base()).completeBaseName() + QStringLiteral("-difference.tif"),
                                     tr("GeoTIFF (*.tif);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveTo(path);
    }
}

void SurveyDisplay::saveTo(const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    const std::shared_ptr<const SurveyWork::Made>& made = m_work.answer.result();
    if (!savable()) {
        return;
    }
    m_session.writeNow(path, [&] {
        const io::MapOrigin origin =
            io::surveyOrigin(*record->reader, made->comparison, made->input, m_document.path().toStdString());
        if (QFileInfo(path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0) {
            figures::SurveyPictureStyle style;
            style.place = io::SitePlace(origin.frame, origin.site).transform();
            style.system = origin.frame.crs;
            style.subject = origin.subject;
            style.provenance = "survey " + made->input.sha256.substr(0, 16) + ", " + io::footLine(record->reader->origin());
            style.cautions =
                widgets::cautionWords(io::surveyCautions(*record->reader, made->input, made->comparison)).toStdString();
            figures::writePng(path.toStdString(), figures::surveyPicture(made->comparison, style));
            io::writeProvenance(path.toStdString(), origin.provenance);
        } else {
            io::writeSurveyTiff(path.toStdString(), made->comparison, origin, Execution());
        }
    });
}

/// Fingerprint of the run that surveys are held against, hex; empty: there is none.
std::string SurveyDisplay::heldRun() const {
    const RunRecord* record = m_computation.currentRun();
    return record != nullptr && record->reader != nullptr ? record->reader->origin().fingerprint.hex() : std::string();
}

void SurveyDisplay::refresh() {
    widgets::SurveyBox::Content content;
    content.available = !m_document.empty();
    content.removals = m_document.theCase().removals;
    const auto all = surveys();
    for (const CaseInput* survey : all) {
        content.names << QFileInfo(QString::fromStdString(survey->path)).fileName();
    }
    m_work.chosen = std::clamp(m_work.chosen, 0, std::max(0, static_cast<int>(all.size()) - 1));
    content.chosen = all.empty() ? -1 : m_work.chosen;
    const std::shared_ptr<const SurveyWork::Made>& made = m_work.answer.result();
    const CaseInput& compared = m_work.answer.answered().survey;
    const bool shown = made != nullptr && current() != nullptr && current()->id == compared.id;
    if (const CaseInput* survey = current(); survey != nullptr) {
        content.cloud = evidenceFormOf(*survey) == EvidenceForm::Cloud;
        content.showsFallen = survey->showsFallen;
        content.scope = survey->scope;
        content.errors = {survey->noise, survey->groundNoise, survey->offsetError};
        content.stated = {survey->taken, survey->before, survey->instant, survey->registration};
        const std::string path = io::inputPath(m_document.base().toStdString(), *survey);
        io::noteOrigin(content.findings, path, m_reach.origin(*survey), heldRun());
        content.findings.append(sameEvidence(m_document.theCase(), survey->id));
        content.findings.append(m_reach.of(*survey));
        content.findings.append(m_reach.unread(*survey));
    }
    content.noComparison = whyNoComparison();
    content.cutsAlong = cutsAlong() && EvidenceWork::whyNoDebris(m_computation.currentRun()).isEmpty();
    const bool failed = m_work.answer.failure() && current() != nullptr && m_work.answer.asked().survey.id == current()->id;
    content.complaint = failed ? m_work.answer.failure()->inOneLine() : QString();
    content.comparing = busy();
    if (current() != nullptr) {
        // A comparison tells what is odd in the points itself.
        const Findings odd = m_reach.odd(*current());
        for (const Finding& finding : odd.list()) {
            if (!shown || finding.what.id == "evidence.other_kind") {
                content.findings.add(finding.what, finding.remedy, finding.example, finding.count);
            }
        }
    }
    if (shown) {
        content.comparison = comparison();
        content.stale = !busy() && stale();
        if (const RunRecord* record = m_computation.currentRun(); record != nullptr && record->reader != nullptr) {
            content.cautions = io::surveyCautions(*record->reader, made->input, made->comparison);
            std::erase_if(content.cautions, [](const Caution& each) { return each.key == "evidence_doubt"; });  // stands below
        }
        // That it is no evidence stands there already, of the run that is shown now.
        content.findings.append(otherThanNoEvidence(made->input.findings));
        content.findings.append(made->comparison.findings);
        if (!compared.sha256.empty() && !io::InputDigest{made->input.sha256, made->input.fileSha256}.is(compared.sha256)) {
            content.findings.add({"survey.changed", "The survey is not the one the case was saved with", {}},
                                 {"survey.changed.remedy", "Find the file with the SHA-256 of the case, or accept it as it is", {}},
                                 made->input.path);
        }
    }
    m_deck.evidence().survey().setContent(content);
    m_reading->show();
    m_page.setSurvey(content.comparison);
    m_page.survey().setScope(content.scope);
    m_page.survey().setMarked(removedPlaces(m_document.theCase()), m_sections->line());
    m_sections->refresh(content.comparison == nullptr || stale());
    emit changed();
}

}  // namespace rubble
