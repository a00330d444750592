#include "app/gui/evidence/survey_reach.h"

#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/site/surveys/survey_reach.h"

namespace rubble {

SurveyReach::SurveyReach(Session& session)
    : m_document(session.document()),
      m_computation(session.computation()),
      m_found(&SurveyReach::lookAt, [this] { emit changed(); }) {
    for (const auto signal : {&Document::replaced, &Document::surveysChanged, &Document::inputsAccepted}) {
        connect(&m_document, signal, this, &SurveyReach::look);
    }
    connect(&m_computation, &Computation::opened, this, &SurveyReach::look);
    connect(&m_computation, &Computation::prepared, this, &SurveyReach::look);
    look();
}

SurveyReach::Asked SurveyReach::askedOf(const CaseInput& survey) const {
    const Inputs& inputs = m_computation.inputs();
    const Aabb structure = io::boundsAtRest(inputs.fe->mesh());
    return {io::inputPath(m_document.base().toStdString(), survey),
            survey.sha256,
            survey.registration,
            survey.read,
            survey.kind,
            inputs.frame,
            m_document.theCase().site,
            structure.min(),
            structure.max()};
}

const SurveyReach::Found* SurveyReach::found(const CaseInput& survey) const {
    return m_computation.inputs().fe != nullptr ? m_found.of(askedOf(survey)) : nullptr;
}

Findings SurveyReach::of(const CaseInput& survey) const {
    const Found* known = found(survey);
    return known != nullptr ? known->place : Findings();
}

Findings SurveyReach::unread(const CaseInput& survey) const {
    const Found* known = found(survey);
    return known != nullptr ? known->unread : Findings();
}

Findings SurveyReach::odd(const CaseInput& survey) const {
    const Found* known = found(survey);
    return known != nullptr ? known->odd : Findings();
}

io::EvidenceOrigin SurveyReach::origin(const CaseInput& survey) const {
    const Found* known = found(survey);
    return known != nullptr ? known->origin : io::EvidenceOrigin();
}

SurveyReach::Found SurveyReach::lookAt(const Asked& asked, const Execution& execution) {
    Found made{{}, {}, {}, io::surveyOriginOf(asked.path, asked.read)};
    try {
        CaseInput survey;
        survey.path = asked.path;
        survey.read = asked.read;
        survey.kind = asked.kind;
        made.odd = io::checkKind(survey, asked.path);
        made.place = io::checkSurveyReach(asked.path, asked.placed, asked.frame, asked.site, Aabb(asked.low, asked.high), execution,
                                          asked.read);
        made.odd.append(io::lookThroughCloud(asked.path, asked.read, execution));
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        made.unread.add(error.message(), error.remedy(), asked.path);
    }
    return made;
}

void SurveyReach::look() {
    std::vector<Asked> asked;
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role == InputRole::Survey && m_computation.inputs().fe != nullptr) {
            asked.push_back(askedOf(input));
        }
    }
    m_found.ask(asked);
}

}  // namespace rubble
