#include "app/gui/evidence/surveys/cloud_placing.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <optional>
#include <utility>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/session.h"
#include "core/evidence/scanned_site.h"
#include "io/case/case_file.h"
#include "io/case/terrain_reader.h"
#include "io/site/clouds/run_distance.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/surveys/fit_dialog.h"

namespace rubble {

CloudPlacing::CloudPlacing(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent)
    : SurveyPlacing(session, page, parent), m_placed(std::move(placed)) {}

void CloudPlacing::open(const CaseInput& survey) {
    const Inputs& inputs = m_computation.inputs();
    if (inputs.fe == nullptr) {
        m_session.tell(tr("A cloud is fitted to the site: open the FE result first."));
        return;
    }
    readToPlace(survey, survey.registration, {}, [this, survey](io::SurveyInput& read) { ask(survey, read); });
}

void CloudPlacing::ask(const CaseInput& survey, io::SurveyInput& read) {
    if (m_computation.inputs().fe == nullptr) {
        return;
    }
    const bool run = EvidenceWork::whyNoDebris(m_computation.currentRun()).isEmpty();
    widgets::FitDialog dialog(std::move(read.survey.heights), QString::fromStdString(read.survey.name),
                              run ? tr("It is fitted to what stands and lies where the run ends.")
                                  : tr("There is no run: it is fitted to the terrain alone."),
                              m_page.window());
    dialog.resize(m_page.window()->size() * 0.8);
    auto placed = std::make_shared<Registration>();
    connect(&dialog, &widgets::FitDialog::fitRequested, this, [&] { fit(dialog, survey, placed); });
    connect(&dialog, &widgets::FitDialog::polygonsRequested, this, [&] { addPolygons(dialog); });
    for (const auto signal : {&widgets::FitDialog::cancelRequested, &widgets::FitDialog::outdated}) {
        connect(&dialog, signal, this, [&] {
            m_worker.cancel();
            dialog.setContent({});
        });
    }
    const bool accepted = dialog.exec() == QDialog::Accepted && dialog.content().found;
    m_worker.cancel();
    if (accepted) {
        m_placed(survey.id, *placed);
    }
}

void CloudPlacing::fit(widgets::FitDialog& dialog, const CaseInput& survey, std::shared_ptr<Registration> placed) {
    struct Outcome {
        CloudFit fit;
        Findings findings;
    };
    auto outcome = std::make_shared<Outcome>();
    const Inputs& inputs = m_computation.inputs();
    io::RunDistanceRequest request;
    request.cloud = io::inputPath(m_document.base().toStdString(), survey);
    request.read = survey.read;
    request.frame = inputs.frame;
    request.site = m_document.theCase().site;
    request.settings = io::scalesOfFit(dialog.radius());
    request.placed = survey.registration;
    request.stable = dialog.stable();
    request.scanners = survey.scanners;
    const RunRecord* record = m_computation.currentRun();
    std::optional<EvidenceRun> run;
    if (EvidenceWork::whyNoDebris(record).isEmpty()) {
        run.emplace(inputs, record);
    }
    const SiteSurface level{true, m_document.scenario().simulation.groundHeight, inputs.terrain};
    dialog.setContent({true, {}, std::nullopt});
    const QPointer<widgets::FitDialog> shown(&dialog);
    m_worker.start({Worker::Kind::Study,
                    [outcome, request, run, level](const Execution& execution) {
                        ScannedSite target;
                        target.ground = level;
                        if (run) {
                            target = scannedSite(run->mapped(), std::nullopt, fallenFrom, execution);
                        }
                        outcome->fit =
                            io::fitCloudToSite(request, std::move(target.shape), target.ground, outcome->findings, execution);
                    },
                    [outcome, shown, placed, before = survey.registration,
                     around = io::boundsAtRest(inputs.fe->mesh())](const std::exception_ptr& thrown) {
                        if (shown == nullptr) {
                            return;
                        }
                        widgets::FitDialog::Content content;
                        if (const auto failure = failureOf(thrown)) {
                            content.complaint = failure->inOneLine();
                        } else if (thrown == nullptr) {
                            *placed = fittedOn(before, outcome->fit, around);
                            content.found = {outcome->fit, placed->error, outcome->findings};
                        }
                        shown->setContent(content);
                    }});
}

void CloudPlacing::addPolygons(widgets::FitDialog& dialog) {
    const QString path = QFileDialog::getOpenFileName(&dialog, tr("What did not move"), QFileInfo(m_document.base()).absolutePath(),
                                                      polygonFileKinds());
    if (path.isEmpty()) {
        return;
    }
    try {
        Findings said;
        dialog.addAreas(
            io::readScope(path.toStdString(), m_document.theCase().frame, m_document.theCase().site, said, Execution()));
    } catch (...) {
        dialog.setContent({false, failureOf(std::current_exception())->inOneLine(), std::nullopt});
    }
}

}  // namespace rubble
