#pragma once

#include <QObject>
#include <functional>
#include <memory>
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
class FitDialog;
}  // namespace widgets

/// Fits a cloud to what did not move: reads it in the background as it lies in the case, then asks where that is.
class CloudPlacing : public QObject {
    Q_OBJECT

public:
    /// What is done with a fit that was accepted. @param id  of the survey
    using Placed = std::function<void(const std::string& id, const Registration& registration)>;

    CloudPlacing(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent = nullptr);

    /// Reads a cloud and opens the dialog.
    void open(const CaseInput& survey);
    bool busy() const { return m_worker.busy(); }

private:
    void ask(const CaseInput& survey, io::SurveyInput& read);
    void fit(widgets::FitDialog& dialog, const CaseInput& survey, std::shared_ptr<Registration> placed);
    void addPolygons(widgets::FitDialog& dialog);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    widgets::EvidencePage& m_page;
    Placed m_placed;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
