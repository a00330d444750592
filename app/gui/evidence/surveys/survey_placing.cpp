#include "app/gui/evidence/surveys/survey_placing.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <memory>
#include <utility>

#include "app/gui/session/session.h"
#include "io/case/case_file.h"

namespace rubble {

SurveyPlacing::SurveyPlacing(Session& session, widgets::EvidencePage& page, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_page(page) {
    connect(&m_document, &Document::replaced, this, [this] { m_worker.cancel(); });
}

void SurveyPlacing::readToPlace(const CaseInput& survey, const std::optional<Registration>& registration,
                                std::function<void(const io::SurveyInput& read, const std::string& path)> usable,
                                std::function<void(io::SurveyInput& read)> ask) {
    m_session.tell(QCoreApplication::translate("rubble::SurveyPlacing", "Reading %1")
                       .arg(QFileInfo(QString::fromStdString(survey.path)).fileName()));
    auto read = std::make_shared<io::SurveyInput>();
    m_worker.start(
        {Worker::Kind::Open,
         [read, registration, usable = std::move(usable), path = io::inputPath(m_document.base().toStdString(), survey),
          frame = m_computation.inputs().frame, site = m_document.theCase().site, as = survey.read](const Execution& execution) {
             *read = io::readSurvey(path, frame, site, Aabb(), execution,
                                    {.holds = io::SurveyRequest::Holds::Heights, .registration = registration, .read = as});
             if (usable) {
                 usable(*read, path);
             }
         },
         [this, read, ask = std::move(ask)](const std::exception_ptr& thrown) {
             if (const auto failure = failureOf(thrown)) {
                 m_session.tell(failure->inOneLine());
             } else if (thrown == nullptr) {
                 m_session.tell({});
                 ask(*read);
             }
         }});
}

}  // namespace rubble
