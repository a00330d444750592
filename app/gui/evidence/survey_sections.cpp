#include "app/gui/evidence/survey_sections.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/surveys/stated_survey.h"
#include "core/scenario/scope_cover.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/exports/survey_files.h"
#include "io/run/run_cautions.h"
#include "io/site/clouds/cloud_comparison.h"
#include "io/site/clouds/height_source.h"
#include "io/site/site_place.h"
#include "io/site/surveys/measured_points.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/surveys/section_dialog.h"
#include "widgets/figures/figure_file.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

/// Where measured heights are brought to, and what of them counts.
struct MeasuredPlace {
    Frame frame;
    Site site;
    const SiteSurface* ground;
    SurveyScope scope;
};

/// Shorter steps than heights lie apart would leave most of them, and of the areas, empty.
void takeStep(SectionLine& line, const SurveyHeights& heights, Findings& findings) {
    if (line.step < heights.spacing()) {
        line.step = heights.spacing();
        findings.add({"section.step", "steps are as long as the heights of the survey lie apart: {0}", {{line.step, "m"}}},
                     {"section.step.remedy", "none is needed", {}});
    }
}

/// Heights of the survey itself: its points, or those of its height model beside the line. An outline has none.
std::vector<MeasuredSet> measuredOf(SurveySections::Order& order, const std::string& path, const MeasuredPlace& at,
                                    Findings& findings, const Execution& execution) {
    const CaseInput& survey = order.survey;
    const bool points = evidenceFormOf(survey) == EvidenceForm::Measured;
    if (order.made != nullptr && order.made->input.survey.isFootprint) {
        return {};
    }
    std::vector<MeasuredSet> measured{{std::filesystem::path(path).filename().string(), {}}};
    if (points || io::holdsCloud(path, survey.read)) {
        measured[0].places =
            io::readMeasuredPoints({path, survey.read, at.frame, at.site, survey.registration, at.scope}, findings, execution);
    } else {
        const SurveyHeights& heights = order.made->input.survey.heights;
        measured[0].places = heightsBeside(heights, *at.ground, order.line);
        takeStep(order.line, heights, findings);
        io::addBeyond(findings, path,
                      std::erase_if(measured[0].places, [&](const Vec3& place) { return !covers(at.scope, place.head<2>()); }));
    }
    return measured;
}

}  // namespace

SurveySections::SurveySections(Session& session, widgets::EvidencePage& page, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_page(page) {
    connect(&m_document, &Document::replaced, this, [this] {
        m_worker.cancel();
        m_order.reset();
        m_section = nullptr;
        show();
    });
}

std::optional<SectionLine> SurveySections::line() const {
    if (!m_order || (m_order->along && m_section == nullptr)) {
        return std::nullopt;
    }
    return m_order->along ? m_section->section.line : m_order->line;
}

void SurveySections::cut(const OutlineRing& ends, const CaseInput& survey, std::shared_ptr<const SurveyWork::Made> made) {
    begin({{ends.front(), ends.back()}, survey, std::move(made)});
}

void SurveySections::cutAlong(const CaseInput& points) {
    begin({{}, points, nullptr, true});
}

void SurveySections::begin(Order order) {
    m_order = std::move(order);
    cutAgain();
    if (m_dialog != nullptr) {
        m_dialog->show();
        m_dialog->raise();
    }
}

void SurveySections::moveEnds(const std::array<Eigen::Vector2d, 2>& ends) {
    if (m_order) {
        const io::SitePlace place(m_computation.inputs().frame, m_document.theCase().site);
        m_order->line.from = place.planToLocal(ends[0]);
        m_order->line.to = place.planToLocal(ends[1]);
        m_order->along = false;
        cutAgain();
    }
}

std::vector<CaseInput> SurveySections::measuredPoints(Findings& said) const {
    std::vector<CaseInput> points;
    const Case& theCase = m_document.theCase();
    for (CaseInput input : theCase.inputs) {
        // Of another instant they would show another site.
        if (input.role == InputRole::Survey && evidenceFormOf(input) == EvidenceForm::Measured &&
            input.held == PointsHeld::Section && !input.before && input.id != m_order->survey.id &&
            input.instant == m_order->survey.instant) {
            input.scope = scopeWhenTaken(theCase, input, said);
            input.path = io::inputPath(m_document.base().toStdString(), input);
            points.push_back(std::move(input));
        }
    }
    return points;
}

void SurveySections::cutAgain() {
    const RunRecord* record = m_computation.currentRun();
    if (!m_order || record == nullptr || record->reader == nullptr) {
        return;
    }
    if (m_dialog == nullptr) {
        m_dialog = new widgets::SectionDialog(m_page.window());
        m_dialog->resize(900, 560);
        connect(m_dialog, &widgets::SectionDialog::changed, this, &SurveySections::cutAgain);
        connect(m_dialog, &widgets::SectionDialog::endsChanged, this, &SurveySections::moveEnds);
        connect(m_dialog, &widgets::SectionDialog::saveRequested, this, &SurveySections::save);
        connect(m_dialog, &QDialog::finished, this, [this] {
            m_order.reset();
            m_section = nullptr;
            emit changed();
        });
    }
    m_order->line.width = m_dialog->width();
    m_order->line.step = m_dialog->step();
    m_section = nullptr;
    m_cutOf = record;
    m_stale = false;
    auto outcome = std::make_shared<io::RunSection>();
    Findings said;
    const Case& theCase = m_document.theCase();
    const SurveyScope scope = scopeWhenTaken(theCase, m_order->survey, said);
    const std::vector<CaseInput> points = measuredPoints(said);
    m_worker.start(
        {Worker::Kind::Study,
         [outcome, order = *m_order, scope, said, points, run = EvidenceRun(m_computation.inputs(), record),
          site = m_document.theCase().site, frame = m_computation.inputs().frame, cut = record->reader->origin().fingerprint.hex(),
          path = io::inputPath(m_document.base().toStdString(), m_order->survey)](const Execution& execution) mutable {
             MappedRun mapped = run.mapped();
             const SiteSurface ground = groundOf(mapped);
             // The ground is added where the line goes, with all of its nodes.
             mapped.terrain = nullptr;
             SiteShape shape = siteOfRun(mapped, order.survey.instant, fallenFrom, Vec3::Zero(), execution);
             Findings findings = said;
             std::vector<MeasuredSet> measured = measuredOf(order, path, {frame, site, &ground, scope}, findings, execution);
             for (const CaseInput& input : points) {
                 measured.push_back({std::filesystem::path(input.path).filename().string(),
                                     io::readMeasuredPoints({input.path, input.read, frame, site, input.registration, input.scope},
                                                            findings, execution)});
             }
             if (order.along) {
                 order.line = io::lineAlongPoints(std::span(measured).first(1), order.line, findings);
             }
             *outcome = io::cutRun(std::move(shape), ground, order.line, measured, execution);
             outcome->section.water = mapped.scenario.effects.waterLevel.value_or(unknown);
             findings.append(outcome->findings);
             outcome->findings = std::move(findings);
             outcome->zero = io::SitePlace(frame, site).transform().height;
             if (measured.size() > points.size()) {
                 io::addMeasuredFile(*outcome, {path, order.survey.sha256}, order.survey.read, cut);
             }
             for (const CaseInput& input : points) {
                 io::addMeasuredFile(*outcome, {input.path, input.sha256}, input.read, cut);
             }
         },
         [this, outcome](const std::exception_ptr& thrown) {
             if (thrown == nullptr) {
                 m_section = outcome;
             }
             const auto failure = failureOf(thrown);
             show(failure ? failure->inOneLine() : QString());
         }});
    show();
}

void SurveySections::refresh(bool mapStale) {
    bool stale = mapStale;
    if (m_order && m_order->made == nullptr) {
        const std::vector<CaseInput>& inputs = m_document.theCase().inputs;
        stale = m_computation.currentRun() != m_cutOf || m_computation.runStale(m_document.scenario()) ||
                std::find(inputs.begin(), inputs.end(), m_order->survey) == inputs.end();
    }
    if (stale != m_stale) {
        m_stale = stale;
        show();
    }
}

void SurveySections::show(const QString& complaint) {
    if (m_dialog != nullptr) {
        widgets::SectionDialog::Content content;
        if (m_section != nullptr) {
            content.section = std::shared_ptr<const SiteSection>(m_section, &m_section->section);
            content.time = m_section->time;
            content.zero = m_section->zero;
            const io::SitePlace place(m_computation.inputs().frame, m_document.theCase().site);
            const SectionLine& line = m_section->section.line;
            content.ends = {place.planToWorld(line.from), place.planToWorld(line.to)};
            content.along = m_order && m_order->along;
            content.findings = m_section->findings;
            if (m_cutOf != nullptr && m_cutOf == m_computation.currentRun() && m_cutOf->reader != nullptr) {
                content.cautions = io::sectionCautions(*m_cutOf->reader, *m_section);
            }
        }
        content.complaint = complaint;
        content.cutting = m_order && m_section == nullptr && complaint.isEmpty();
        content.stale = m_stale;
        m_dialog->setContent(content);
    }
    emit changed();
}

void SurveySections::save() {
    const QString path =
        askSavePath(m_dialog, tr("Section"), QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/section.png"),
                    tr("Images (*.png)"));
    if (!path.isEmpty()) {
        saveTo(path);
    }
}

void SurveySections::saveTo(const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    if (m_section == nullptr || m_stale || record == nullptr || record->reader == nullptr) {
        return;
    }
    m_session.writeNow(path, [&] {
        const io::RunReader& run = *record->reader;
        const io::SitePlace place(run.origin().frame, m_document.theCase().site);
        const SectionLine& line = m_section->section.line;
        figures::SectionPictureStyle style = m_dialog->printed();
        style.note = figures::SectionNote{m_section->time,
                                          place.planToWorld(line.from),
                                          place.planToWorld(line.to),
                                          line.width,
                                          place.system(),
                                          widgets::cautionWords(io::sectionCautions(run, *m_section)),
                                          io::sectionFoot(run, *m_section)};
        const std::string provenance = io::sectionProvenance(run, *m_section, place);
        figures::writePng(path.toStdString(), figures::sectionPicture(m_section->section, style), provenance);
        io::writeProvenance(path.toStdString(), provenance);
    });
}

}  // namespace rubble
