#include "app/gui/evidence/surveys/survey_placing.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <memory>
#include <utility>

#include "app/gui/session/session.h"
#include "app/gui/session/worker.h"
#include "io/case/case_file.h"

namespace rubble {

void readToPlace(Worker& worker, Session& session, const CaseInput& survey, const std::optional<Registration>& registration,
                 std::function<void(const io::SurveyInput& read, const std::string& path)> usable,
                 std::function<void(io::SurveyInput& read)> ask) {
    session.tell(QCoreApplication::translate("rubble::SurveyPlacing", "Reading %1")
                     .arg(QFileInfo(QString::fromStdString(survey.path)).fileName()));
    auto read = std::make_shared<io::SurveyInput>();
    const Document& document = session.document();
    worker.start({Worker::Kind::Open,
                  [read, registration, usable = std::move(usable), path = io::inputPath(document.base().toStdString(), survey),
                   frame = session.computation().inputs().frame, site = document.theCase().site,
                   as = survey.read](const Execution& execution) {
                      *read =
                          io::readSurvey(path, frame, site, Aabb(), execution,
                                         {.holds = io::SurveyRequest::Holds::Heights, .registration = registration, .read = as});
                      if (usable) {
                          usable(*read, path);
                      }
                  },
                  [read, &session, ask = std::move(ask)](const std::exception_ptr& thrown) {
                      if (const auto failure = failureOf(thrown)) {
                          session.tell(failure->inOneLine());
                      } else if (thrown == nullptr) {
                          session.tell({});
                          ask(*read);
                      }
                  }});
}

}  // namespace rubble
