#include "app/gui/evidence/surveys/survey_work.h"

#include <utility>

#include "app/gui/session/session.h"
#include "core/evidence/evidence_list.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/exports/survey_files.h"
#include "io/site/site_place.h"

namespace rubble {

bool SurveyWork::Compared::operator==(const Compared& other) const {
    return survey == other.survey && run == other.run && settings.cell == other.settings.cell &&
           settings.leastHeight == other.settings.leastHeight && settings.fit == other.settings.fit &&
           settings.withFallen == other.settings.withFallen && settings.scope == other.settings.scope;
}

SurveyWork::SurveyWork(Session& session) {
    connect(&session.document(), &Document::replaced, this, [this] {
        m_making = nullptr;
        chosen = 0;
        answer.drop();
        cancel();
    });
}

void SurveyWork::start(const Compared& order, const EvidenceRun& run, const Case& theCase, const Frame& frame,
                       const std::string& path) {
    answer.ask(order);
    const io::RunOrigin ground = order.origin;
    m_making = std::make_shared<Made>();
    m_worker.start({Worker::Kind::Study,
                    [made = m_making, path, run, frame, ground, site = theCase.site, survey = order.survey,
                     settings = order.settings, said = order.said](const Execution& execution) mutable {
                        const io::SurveyRequest wanted = io::surveyRequest(ground, survey);
                        checkHasOverlap(survey);
                        site.groundClasses = ground.site.groundClasses;
                        const io::SiteWindow window(io::boundsAtRest(run.fe->mesh()), debrisBounds(run.mapped(), survey.instant));
                        made->input = io::readSurvey(path, frame, site, window, execution, wanted);
                        made->input.findings.append(said);
                        settings.turn = io::SitePlace(frame, site).transform().angle;
                        made->comparison =
                            compareRunWithSurvey(run.mapped(), survey.instant, made->input.survey, settings, execution);
                    },
                    [this, made = m_making](const std::exception_ptr& thrown) { take(made, thrown); }});
    emit changed();
}

void SurveyWork::take(const std::shared_ptr<Made>& made, const std::exception_ptr& thrown) {
    // None is awaited any more when another case was opened meanwhile.
    const bool awaited = thrown == nullptr && made == m_making;
    if (awaited) {
        answer.take(std::move(m_making));
    }
    const auto failure = failureOf(thrown);
    answer.end(failure ? &*failure : nullptr);
    if (awaited) {
        emit compared();
    }
    emit changed();
}

void SurveyWork::cancel() {
    m_worker.cancel();
    if (!m_worker.busy()) {
        answer.end();
    }
    emit changed();
}

}  // namespace rubble
