#include "app/gui/survey_display.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/computation.h"
#include "app/gui/document.h"
#include "app/gui/panel_deck.h"
#include "core/base/error.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/geo/survey_files.h"
#include "io/provenance.h"
#include "io/terrain/site_place.h"
#include "io/terrain_reader.h"
#include "widgets/evidence_page.h"
#include "widgets/evidence_panel.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/survey_picture.h"
#include "widgets/survey_box.h"

namespace rubble {

SurveyDisplay::SurveyDisplay(Document& document, Computation& computation, PanelDeck& deck, widgets::EvidencePage& page,
                             QObject* parent)
    : QObject(parent), m_document(document), m_computation(computation), m_deck(deck), m_page(page) {
    widgets::SurveyBox& box = deck.evidence().survey();
    connect(&box, &widgets::SurveyBox::addRequested, this, &SurveyDisplay::chooseFile);
    connect(&box, &widgets::SurveyBox::removeRequested, this, &SurveyDisplay::remove);
    connect(&box, &widgets::SurveyBox::compareRequested, this, &SurveyDisplay::compare);
    connect(&box, &widgets::SurveyBox::cancelRequested, this, &SurveyDisplay::cancel);
    connect(&box, &widgets::SurveyBox::saveRequested, this, &SurveyDisplay::save);
    connect(&box, &widgets::SurveyBox::settingsChanged, this, &SurveyDisplay::refresh);
    connect(&box, &widgets::SurveyBox::showsFallenChosen, this, &SurveyDisplay::setShowsFallen);
    connect(&box, &widgets::SurveyBox::chosen, this, [this](int survey) {
        m_chosen = survey;
        refresh();
    });
    connect(&m_document, &Document::replaced, this, [this] {
        m_work.cancel();
        m_made = nullptr;
        m_chosen = 0;
        m_comparison = nullptr;
        m_input = nullptr;
        m_complaint.clear();
        refresh();
    });
    connect(&m_document, &Document::inputsAccepted, this, &SurveyDisplay::refresh);
    connect(&m_document, &Document::surveysChanged, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runBegun, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::runReopened, this, &SurveyDisplay::refresh);
    connect(&m_computation, &Computation::prepared, this, &SurveyDisplay::refresh);
    refresh();
}

SurveyDisplay::~SurveyDisplay() = default;

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
    return m_chosen >= 0 && m_chosen < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(m_chosen)] : nullptr;
}

void SurveyDisplay::chooseFile() {
    if (m_document.empty()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(
        m_page.window(), tr("Add a survey"), QFileInfo(m_document.base()).absolutePath(),
        tr("Height models and outlines (*.tif *.tiff *.asc *.bil *.img *.xyz *.grd *.gpkg *.geojson *.json *.shp *.fgb *.kml);;All "
           "files (*)"));
    if (!path.isEmpty()) {
        add(path);
    }
}

void SurveyDisplay::add(const QString& path) {
    std::vector<CaseInput> inputs = m_document.theCase().inputs;
    std::string id;
    for (int number = 1; id.empty() || std::any_of(inputs.begin(), inputs.end(), [&](const CaseInput& i) { return i.id == id; });
         ++number) {
        id = "survey-" + std::to_string(number);
    }
    const QDir folder = QFileInfo(m_document.base()).absoluteDir();
    inputs.push_back({id, InputRole::Survey, folder.relativeFilePath(path).toStdString(), {}});
    try {
        inputs.back().sha256 = io::sha256OfFile(path.toStdString());
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        emit failed(failure->what, failure->remedy);
        return;
    }
    m_chosen = static_cast<int>(surveys().size());
    m_deck.choose(PanelDeck::Evidence);
    m_document.setSurveys(std::move(inputs), tr("survey %1 added").arg(QFileInfo(path).fileName()));
}

void SurveyDisplay::remove() {
    if (const CaseInput* survey = current(); survey != nullptr) {
        std::vector<CaseInput> inputs = m_document.theCase().inputs;
        std::erase_if(inputs, [id = survey->id](const CaseInput& input) { return input.id == id; });
        m_chosen = std::max(0, m_chosen - 1);
        m_document.setSurveys(std::move(inputs), tr("survey removed"));
    }
}

void SurveyDisplay::setShowsFallen(std::optional<bool> shows) {
    if (const CaseInput* survey = current(); survey != nullptr && survey->showsFallen != shows) {
        std::vector<CaseInput> inputs = m_document.theCase().inputs;
        for (CaseInput& input : inputs) {
            input.showsFallen = input.id == survey->id ? shows : input.showsFallen;
        }
        m_document.setSurveys(std::move(inputs), tr("what the survey shows"));
    }
}

QString SurveyDisplay::whyNot() const {
    const RunRecord* record = m_computation.currentRun();
    return record == nullptr || record->reader == nullptr || record->running ? tr("Simulate first: there is no debris yet.")
                                                                             : QString();
}

bool SurveyDisplay::stale() const {
    const RunRecord* record = m_computation.currentRun();
    const CaseInput* survey = current();
    const SurveySettings now = m_deck.evidence().survey().settings();
    const SurveySettings& then = m_comparedSettings;
    return record == nullptr || survey == nullptr || m_comparedRun != record->reader.get() || !(*survey == m_comparedWith) ||
           now.cell != then.cell || now.leastHeight != then.leastHeight || now.fit != then.fit ||
           now.withFallen != then.withFallen || m_computation.runStale(m_document.scenario());
}

void SurveyDisplay::compare() {
    const CaseInput* survey = current();
    if (survey == nullptr || !whyNot().isEmpty() || m_comparing) {
        return;
    }
    const RunRecord* record = m_computation.currentRun();
    m_comparing = true;
    m_complaint.clear();
    m_comparedWith = *survey;
    m_comparedSettings = m_deck.evidence().survey().settings();
    m_comparedSettings.showsFallen = survey->showsFallen;
    m_comparedRun = record->reader.get();
    m_made = std::make_shared<SurveyComparison>();
    m_read = std::make_shared<io::SurveyInput>();
    const std::string path = io::inputPath(m_document.base().toStdString(), *survey);
    m_work.start({Worker::Kind::Study,
                  [made = m_made, read = m_read, path, run = EvidenceRun(m_computation.inputs(), record),
                   frame = m_computation.inputs().frame, site = m_document.theCase().site,
                   settings = m_comparedSettings](const Execution& execution) mutable {
                      *read = io::readSurvey(path, frame, site, io::boundsAtRest(run.fe->mesh()), execution);
                      settings.turn = io::SitePlace(frame, site).transform().angle;
                      *made = compareRunWithSurvey(run.mapped(), std::nullopt, read->survey, settings, execution);
                  },
                  [this](const std::exception_ptr& thrown) { take(thrown); }});
    refresh();
}

void SurveyDisplay::take(const std::exception_ptr& thrown) {
    m_comparing = false;
    if (const auto failure = failureOf(thrown)) {
        m_complaint = failure->what + u' ' + failure->remedy;
    } else if (thrown == nullptr && m_made != nullptr) {
        // None is awaited any more when another case was opened meanwhile.
        m_comparison = m_made;
        m_input = m_read;
        m_page.showSurvey(true);
    }
    refresh();
}

void SurveyDisplay::cancel() {
    m_work.cancel();
    m_comparing = m_work.busy();
    refresh();
}

void SurveyDisplay::save() {
    const QString path = QFileDialog::getSaveFileName(m_page.window(), tr("Difference map"),
                                                      QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/survey.tif"),
                                                      tr("GeoTIFF (*.tif);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveTo(path);
    }
}

void SurveyDisplay::saveTo(const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    if (m_comparison == nullptr || record == nullptr || record->reader == nullptr || stale()) {
        emit failed(tr("The comparison is of another run or other settings."), tr("Compare again, then save."));
        return;
    }
    try {
        const io::MapOrigin origin = io::surveyOrigin(*record->reader, *m_comparison, *m_input);
        if (QFileInfo(path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0) {
            figures::SurveyPictureStyle style;
            style.place = io::SitePlace(origin.frame, origin.site).transform();
            style.system = origin.frame.crs;
            style.provenance = "survey " + m_input->sha256.substr(0, 16) + ", " + io::footLine(record->reader->origin());
            figures::writePng(path.toStdString(), figures::surveyPicture(*m_comparison, style));
            io::writeProvenance(path.toStdString(), origin.provenance);
        } else {
            io::writeSurveyTiff(path.toStdString(), *m_comparison, origin, Execution());
        }
        emit told(tr("Saved %1").arg(QFileInfo(path).fileName()));
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        emit failed(failure->what, failure->remedy);
    }
}

void SurveyDisplay::refresh() {
    widgets::SurveyBox::Content content;
    content.available = !m_document.empty();
    const auto all = surveys();
    for (const CaseInput* survey : all) {
        content.names << QFileInfo(QString::fromStdString(survey->path)).fileName();
    }
    m_chosen = std::clamp(m_chosen, 0, std::max(0, static_cast<int>(all.size()) - 1));
    content.chosen = all.empty() ? -1 : m_chosen;
    content.showsFallen = all.empty() ? std::nullopt : all[static_cast<std::size_t>(m_chosen)]->showsFallen;
    content.noComparison = whyNot();
    content.complaint = m_complaint;
    content.comparing = m_comparing;
    if (m_comparison != nullptr && current() != nullptr && current()->id == m_comparedWith.id) {
        content.comparison = m_comparison;
        content.stale = !m_comparing && stale();
        content.findings = m_input->findings;
        content.findings.append(m_comparison->findings);
        if (!m_comparedWith.sha256.empty() && m_comparedWith.sha256 != m_input->sha256) {
            content.findings.add({"survey.changed", "The survey is not the one the case was saved with", {}},
                                 {"survey.changed.remedy", "Find the file with the SHA-256 of the case, or accept it as it is", {}},
                                 m_input->path);
        }
    }
    m_deck.evidence().survey().setContent(content);
    m_page.setSurvey(content.comparison);
}

}  // namespace rubble
