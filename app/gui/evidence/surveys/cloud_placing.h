#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <string>

#include "app/gui/evidence/surveys/survey_placing.h"
#include "core/scenario/case.h"

namespace rubble {

namespace widgets {
class FitDialog;
}  // namespace widgets

/// Fits a cloud to what did not move: reads it in the background as it lies in the case, then asks where that is.
class CloudPlacing : public SurveyPlacing {
    Q_OBJECT

public:
    /// What is done with a fit that was accepted. @param id  of the survey
    using Placed = std::function<void(const std::string& id, const Registration& registration)>;

    CloudPlacing(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent = nullptr);

    /// Reads a cloud and opens the dialog.
    void open(const CaseInput& survey);

private:
    void ask(const CaseInput& survey, io::SurveyInput& read);
    void fit(widgets::FitDialog& dialog, const CaseInput& survey, std::shared_ptr<Registration> placed);
    void addPolygons(widgets::FitDialog& dialog);

    Placed m_placed;
};

}  // namespace rubble
