#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "app/gui/evidence/surveys/survey_placing.h"
#include "core/evidence/surveys/pair_fit.h"
#include "core/scenario/case.h"

namespace rubble {

namespace widgets {
class PlacePairsDialog;
}  // namespace widgets

/// Places a survey by places that are clicked in it and in the model: reads it in the background as its coordinates say, then asks.
class SurveyPairs : public SurveyPlacing {
    Q_OBJECT

public:
    /// What is done with pairs that were accepted. @param id  of the survey
    using Placed = std::function<void(const std::string& id, const PairFit& fit)>;

    SurveyPairs(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent = nullptr);

    /// Reads a survey and opens the dialog.
    void pick(const CaseInput& survey);

private:
    void ask(const std::string& id, io::SurveyInput& read);

    Placed m_placed;
};

}  // namespace rubble
