#pragma once

#include <QObject>
#include <map>
#include <string>

#include "core/scenario/case.h"

namespace rubble {

class Computation;
class Document;
class EvidenceDisplay;
class PanelDeck;
class PhotographPlaces;
class Session;
class SurveyDisplay;
class SurveyReach;

/// The list of all evidence at the top of its panel. Scores are those of the comparisons that were made; one of another run, or of
/// evidence that was changed since, is left out.
class EvidenceListDisplay : public QObject {
    Q_OBJECT

public:
    EvidenceListDisplay(Session& session, PanelDeck& deck, EvidenceDisplay& photographs, SurveyDisplay& surveys,
                        QObject* parent = nullptr);

    void refresh();

private:
    /// What a comparison gave.
    struct Score {
        CaseInput survey;       ///< as it was compared
        Photograph photograph;  ///< as it was compared
        const void* run = nullptr;
        double overlap = 0.0;
        EvidenceSettings evidence{};  ///< that it was compared with
    };
    void keepNewest();
    void choose(const std::string& id);

    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    EvidenceDisplay& m_photographs;
    SurveyDisplay& m_surveys;
    SurveyReach& m_reach;
    PhotographPlaces& m_places;
    std::map<std::string, Score> m_scores;  ///< by id of the input
};

}  // namespace rubble
