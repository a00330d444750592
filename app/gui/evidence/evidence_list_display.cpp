#include "app/gui/evidence/evidence_list_display.h"

#include <algorithm>
#include <cmath>

#include "app/gui/evidence/evidence_display.h"
#include "app/gui/evidence/photograph_places.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "core/evidence/cautions.h"
#include "core/evidence/evidence_list.h"
#include "io/site/surveys/evidence_origin.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"

namespace rubble {

namespace {

const CaseInput* inputOf(const Case& theCase, const std::string& id) {
    const auto found =
        std::find_if(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) { return input.id == id; });
    return found != theCase.inputs.end() ? &*found : nullptr;
}

const Photograph* photographOf(const Case& theCase, const std::string& id) {
    const auto found = std::find_if(theCase.photographs.begin(), theCase.photographs.end(),
                                    [&](const Photograph& photograph) { return photograph.input == id; });
    return found != theCase.photographs.end() ? &*found : nullptr;
}

}  // namespace

EvidenceListDisplay::EvidenceListDisplay(Session& session, PanelDeck& deck, EvidenceDisplay& photographs, SurveyDisplay& surveys,
                                         QObject* parent)
    : QObject(parent),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_photographs(photographs),
      m_surveys(surveys),
      m_reach(session.part<SurveyReach>()),
      m_places(session.part<PhotographPlaces>()) {
    connect(&deck.evidence().list(), &widgets::EvidenceTable::chosen, this,
            [this](const QString& id) { choose(id.toStdString()); });
    connect(&deck.evidence().list(), &widgets::EvidenceTable::held, this, [this](const QString& id, PointsHeld as) {
        choose(id.toStdString());
        m_surveys.edit([as](CaseInput& input) { input.held = as; }, [] { return tr("what measured points are held to say"); });
    });
    connect(&photographs, &EvidenceDisplay::changed, this, &EvidenceListDisplay::refresh);
    connect(&surveys, &SurveyDisplay::changed, this, &EvidenceListDisplay::refresh);
    connect(&m_places, &PhotographPlaces::changed, this, &EvidenceListDisplay::refresh);
    connect(&m_document, &Document::replaced, this, [this] {
        m_scores.clear();
        refresh();
    });
    refresh();
}

void EvidenceListDisplay::keepNewest() {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr) {
        return;
    }
    const Case& theCase = m_document.theCase();
    const CaseInput* survey = m_surveys.current();
    if (const auto made = m_surveys.comparison(); made != nullptr && survey != nullptr && !m_surveys.stale()) {
        m_scores[survey->id] = {*survey, {}, record->reader.get(), made->iou, theCase.evidence};
    }
    const int chosen = m_photographs.chosen();
    if (chosen >= 0 && chosen < static_cast<int>(theCase.photographs.size())) {
        const Photograph& photograph = theCase.photographs[static_cast<std::size_t>(chosen)];
        const auto compared = m_photographs.comparison();
        double overlap = unknown;
        if (compared != nullptr && !m_photographs.comparisonStale()) {
            overlap = compared->iou.best;
        }
        Score& score = m_scores[photograph.input];
        const bool other =
            !(score.photograph == photograph) || score.run != record->reader.get() || !(score.evidence == theCase.evidence);
        if (other || !std::isnan(overlap)) {
            score = {{}, photograph, record->reader.get(), overlap, theCase.evidence};
        }
    }
}

void EvidenceListDisplay::refresh() {
    keepNewest();
    const RunRecord* record = m_computation.currentRun();
    const bool current = record != nullptr && !m_computation.runStale(m_document.scenario());
    const Case& theCase = m_document.theCase();
    std::vector<EvidenceRow> rows = m_document.empty() ? std::vector<EvidenceRow>() : evidenceOf(theCase);
    for (EvidenceRow& row : rows) {
        const CaseInput* input = inputOf(theCase, row.id);
        if (const Findings far = input != nullptr ? m_reach.of(*input) : Findings(); !far.empty()) {
            row.elsewhere = far.list().front().what;
        }
        if (const Findings unread = input != nullptr ? m_reach.unread(*input) : Findings(); !unread.empty()) {
            row.unread = unread.list().front().what;
        }
        const Photograph* photograph = photographOf(theCase, row.id);
        if (photograph != nullptr) {
            const PhotographPlaces::Place place = m_places.of(*photograph);
            io::takeOrigin(row, place.origin);
            // The chosen one is matched at once, the others soon after.
            const bool chosen = photograph - theCase.photographs.data() == m_photographs.chosen();
            row.within = chosen && m_photographs.match() ? m_photographs.match()->placeRadius : place.within;
        } else if (input != nullptr) {
            io::takeOrigin(row, m_reach.origin(*input));
        }
        const auto kept = m_scores.find(row.id);
        if (kept == m_scores.end()) {
            continue;
        }
        const Score& score = kept->second;
        const bool same = photograph != nullptr ? score.photograph == *photograph : input != nullptr && score.survey == *input;
        if (same && current && score.run == record->reader.get() && score.evidence == theCase.evidence) {
            row.score = score.overlap;
        }
    }
    m_deck.evidence().list().setRows(rows);
}

void EvidenceListDisplay::choose(const std::string& id) {
    const Case& theCase = m_document.theCase();
    if (const Photograph* photograph = photographOf(theCase, id)) {
        m_photographs.choose(static_cast<int>(photograph - theCase.photographs.data()));
    } else {
        m_surveys.choose(id);
    }
}

}  // namespace rubble
