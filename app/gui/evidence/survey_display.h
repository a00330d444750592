#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/evidence/surveys/survey_work.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/survey_view.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class Session;
class CloudPlacing;
class SurveyPairs;
class SurveyReach;
class SurveyReading;
class SurveySections;
namespace widgets {
class EvidencePage;
}

/// Brings the surveys of the case together with their box in the Evidence panel, the difference map in the centre and the run.
/// Comparing runs in the background; adding and removing a survey are undoable commands.
class SurveyDisplay : public QObject {
    Q_OBJECT

public:
    SurveyDisplay(Session& session, PanelDeck& deck, widgets::EvidencePage& page, Actions& actions, QObject* parent = nullptr);
    ~SurveyDisplay() override;

    void chooseFile();
    void add(const QString& path);
    /// Takes polygons of a file into what is compared of the current survey.
    void addScope(ScopePart part, const QString& path);
    void compare();
    void cancel();
    bool busy() const { return m_work.answer.running(); }
    /// Null: nothing was compared.
    std::shared_ptr<const SurveyComparison> comparison() const;
    /// Writes the difference map as GeoTIFF or PNG, by the ending.
    void saveTo(const QString& path);
    void refresh();
    /// The survey that is worked on; null: there is none.
    const CaseInput* current() const;
    /// Works on the survey of this id, if there is one.
    void choose(const std::string& id);
    /// The comparison is of another survey, another run or other settings.
    bool stale() const;
    /// Places the current survey by the pairs of a table, as one undoable command.
    void placeByPairs(const QString& path);
    SurveyPairs& picking() { return *m_pairs; }
    CloudPlacing& fitting() { return *m_fit; }
    SurveySections& sections() { return *m_sections; }
    /// Adds a place whose debris was gone from a time on, as one undoable command; one of a file likewise.
    void addRemoval(Removal removal);
    void addRemovalOf(const std::string& since, const QString& path);

    /// Changes what the case says of the current survey, as one undoable command.
    void edit(const std::function<void(CaseInput&)>& change, const widgets::Wording& what);

signals:
    /// What the box shows has changed.
    void changed();

private:
    std::vector<const CaseInput*> surveys() const;
    QString whyNoComparison() const;
    SurveyWork::Compared comparedNow(const CaseInput& survey, const RunRecord& record) const;
    /// Keeps how a survey lies, as one undoable command.
    void place(const std::string& id, const Registration& registration, const widgets::Wording& what);
    void connectPlace();
    void connectRemovals();
    void connectMap();
    void draw(widgets::SurveyView::Draws what);
    /// The current survey is measured points for sections: these need no map to draw on.
    bool cutsAlong() const;
    void startSection();
    void take(widgets::SurveyView::Draws what, const OutlineRing& ring);
    void editRemovals(const std::function<void(std::vector<Removal>&)>& change, const widgets::Wording& what);
    void chooseRemoval(const std::string& since);
    void choosePairs();
    void remove();
    void setShowsFallen(std::optional<bool> shows);
    void chooseScope(ScopePart part);
    /// Reads polygons of a file and hands them over; what goes wrong is told.
    void readPolygons(const QString& path, const std::function<void(Outline)>& take);
    void save();
    bool savable();
    std::string heldRun() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    SurveyWork& m_work;
    SurveyReach& m_reach;
    std::string m_removedSince;  ///< of what is being drawn
    SurveyPairs* m_pairs;
    CloudPlacing* m_fit;
    SurveyReading* m_reading;
    SurveySections* m_sections;
};

}  // namespace rubble
