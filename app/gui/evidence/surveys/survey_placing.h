#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <string>

#include "app/gui/session/worker.h"
#include "core/scenario/case.h"
#include "io/site/survey_file.h"

namespace rubble {

class Computation;
class Document;
class Session;
namespace widgets {
class EvidencePage;
}

/// Asks in a dialog where a survey of the case lies, once its heights were read in the background. Another case ends that.
class SurveyPlacing : public QObject {
public:
    bool busy() const { return m_worker.busy(); }

protected:
    SurveyPlacing(Session& session, widgets::EvidencePage& page, QObject* parent);

    /// Reads the heights of a survey; what fails is told.
    /// @param registration  by which they are moved once they lie in the case's frame
    /// @param usable  throws a UsageError where what was read from the path cannot be placed; runs in the background
    /// @param ask  is given what was read, on the GUI thread
    void readToPlace(const CaseInput& survey, const std::optional<Registration>& registration,
                     std::function<void(const io::SurveyInput& read, const std::string& path)> usable,
                     std::function<void(io::SurveyInput& read)> ask);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    widgets::EvidencePage& m_page;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
