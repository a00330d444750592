#include "app/gui/evidence/survey_reach.h"

#include <algorithm>
#include <memory>

#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/case_surveys.h"
#include "io/case/terrain_reader.h"
#include "io/site/surveys/survey_reach.h"

namespace rubble {

SurveyReach::SurveyReach(Session& session) : m_document(session.document()), m_computation(session.computation()) {
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

const SurveyReach::Known* SurveyReach::known(const CaseInput& survey) const {
    if (m_known.empty() || m_computation.inputs().fe == nullptr) {
        return nullptr;
    }
    const auto found =
        std::find_if(m_known.begin(), m_known.end(), [asked = askedOf(survey)](const Known& each) { return each.asked == asked; });
    return found != m_known.end() ? &*found : nullptr;
}

Findings SurveyReach::of(const CaseInput& survey) const {
    const Known* found = known(survey);
    return found != nullptr ? found->place : Findings();
}

Findings SurveyReach::unread(const CaseInput& survey) const {
    const Known* found = known(survey);
    return found != nullptr ? found->unread : Findings();
}

Findings SurveyReach::odd(const CaseInput& survey) const {
    const Known* found = known(survey);
    return found != nullptr ? found->odd : Findings();
}

io::EvidenceOrigin SurveyReach::origin(const CaseInput& survey) const {
    const Known* found = known(survey);
    return found != nullptr ? found->origin : io::EvidenceOrigin();
}

SurveyReach::Known SurveyReach::lookAt(const Asked& asked, const Execution& execution) {
    Known made{asked, {}, {}, {}, io::surveyOriginOf(asked.path, asked.read)};
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
    std::vector<Asked> wanted;
    std::vector<Known> still;
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role != InputRole::Survey || m_computation.inputs().fe == nullptr) {
            continue;
        }
        const Asked asked = askedOf(input);
        const auto found = std::find_if(m_known.begin(), m_known.end(), [&](const Known& each) { return each.asked == asked; });
        if (found != m_known.end()) {
            still.push_back(*found);
        } else {
            wanted.push_back(asked);
        }
    }
    m_known = std::move(still);
    if (wanted == m_asking) {
        return;
    }
    m_asking = wanted;
    if (wanted.empty()) {
        m_worker.cancel();
        return;
    }
    auto made = std::make_shared<std::vector<Known>>();
    m_worker.start({Worker::Kind::Study,
                    [made, wanted](const Execution& execution) {
                        for (const Asked& each : wanted) {
                            made->push_back(lookAt(each, execution));
                        }
                    },
                    [this, made, wanted](const std::exception_ptr& thrown) {
                        if (thrown == nullptr && wanted == m_asking) {
                            m_asking.clear();
                            m_known.insert(m_known.end(), made->begin(), made->end());
                            emit changed();
                        }
                    }});
}

}  // namespace rubble
