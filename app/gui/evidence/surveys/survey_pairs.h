#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/evidence/surveys/pair_fit.h"
#include "core/scenario/case.h"
#include "io/site/survey_file.h"

namespace rubble {

class Computation;
class Document;
class Session;
namespace widgets {
class EvidencePage;
class PlacePairsDialog;
}  // namespace widgets

/// Places a survey by places that are clicked in it and in the model: reads it in the background as its coordinates say, then asks.
class SurveyPairs : public QObject {
    Q_OBJECT

public:
    /// What is done with pairs that were accepted. @param id  of the survey
    using Placed = std::function<void(const std::string& id, const PairFit& fit)>;

    SurveyPairs(Session& session, widgets::EvidencePage& page, Placed placed, QObject* parent = nullptr);

    /// Reads a survey and opens the dialog.
    void pick(const CaseInput& survey);
    bool busy() const { return m_worker.busy(); }

private:
    void ask(const std::string& id, io::SurveyInput& read);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    widgets::EvidencePage& m_page;
    Placed m_placed;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
