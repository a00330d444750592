#include "app/gui/evidence/surveys/survey_reading.h"

#include <utility>

#include "app/gui/case/cloud_reading.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "core/evidence/evidence_list.h"
#include "io/case/case_file.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/surveys/reading_box.h"

namespace rubble {

SurveyReading::SurveyReading(Session& session, PanelDeck& deck, QWidget* window, Current current, Read read, QObject* parent)
    : QObject(parent),
      m_document(session.document()),
      m_deck(deck),
      m_window(window),
      m_current(std::move(current)),
      m_read(std::move(read)) {
    widgets::ReadingBox& box = deck.evidence().survey().reading();
    connect(&box, &widgets::ReadingBox::edited, this, [this, &box](const CloudRequest& said) {
        if (const CaseInput* survey = m_current()) {
            CaseInput changed = *survey;
            const QString complaint = tryCloudReading(changed, io::inputPath(m_document.base().toStdString(), changed), said);
            box.setComplaint(complaint);
            if (complaint.isEmpty()) {
                m_read(changed);
            }
        }
    });
}

bool SurveyReading::ask(CaseInput& survey, const QString& path) {
    return askCloudReading(m_window, survey, path, m_document.theCase().frame);
}

void SurveyReading::show() {
    const CaseInput* survey = m_current();
    widgets::ReadingBox& box = m_deck.evidence().survey().reading();
    // A table that nothing reads yet needs its columns most.
    const bool asked = survey != nullptr && (evidenceFormOf(*survey) == EvidenceForm::Cloud || !survey->read.empty());
    box.setVisible(asked);
    // What is being typed stays while other things change.
    const Shown now = survey != nullptr ? Shown{survey->id, survey->read} : Shown();
    if (!(now == m_shown)) {
        m_shown = now;
        box.setComplaint({});
        box.setRequest(now.second);
    }
}

}  // namespace rubble
