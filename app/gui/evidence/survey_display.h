#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/session/worker.h"
#include "app/gui/studies/answer.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"
#include "io/run/run_file.h"
#include "io/site/survey_file.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/survey_view.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class Session;
class SurveyPairs;
class SurveyReach;
class SurveySections;
namespace widgets {
class EvidencePage;
}

/// The comparison with a survey, whoever shows it.
class SurveyWork : public QObject {
    Q_OBJECT

public:
    /// What a survey is held against, and how.
    struct Compared {
        CaseInput survey;
        const void* run = nullptr;
        SurveySettings settings;
        io::RunOrigin origin = {};  ///< of the run
        Findings said = {};         ///< of what the case says of the survey
        /// What can be chosen is the same.
        bool operator==(const Compared& other) const;
    };
    struct Made {
        SurveyComparison comparison;
        io::SurveyInput input;  ///< what was compared with
    };

    explicit SurveyWork(Session& session);

    /// Compares a run with a survey; answers with changed(). @param path  of the survey
    void start(const Compared& order, const EvidenceRun& run, const Case& theCase, const Frame& frame, const std::string& path);
    void cancel();

    int chosen = 0;
    Answer<Compared, Made> answer;
    std::optional<SurveySettings> asked;  ///< what the fields asked for when a window went
    bool shown = false;                   ///< its map stood in the centre then

signals:
    void changed();
    /// There is another comparison.
    void compared();

private:
    void take(const std::shared_ptr<Made>& made, const std::exception_ptr& thrown);

    std::shared_ptr<Made> m_making;  // null: what is made is not awaited any more
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

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
    SurveySections& sections() { return *m_sections; }
    /// Adds a place whose debris was gone from a time on, as one undoable command; one of a file likewise.
    void addRemoval(Removal removal);
    void addRemovalOf(const std::string& since, const QString& path);

signals:
    /// What the box shows has changed.
    void changed();

private:
    std::vector<const CaseInput*> surveys() const;
    SurveyWork::Compared comparedNow(const CaseInput& survey, const RunRecord& record) const;
    void connectPlace();
    void connectRemovals();
    void connectMap();
    void draw(widgets::SurveyView::Draws what);
    void take(widgets::SurveyView::Draws what, const OutlineRing& ring);
    void editRemovals(const std::function<void(std::vector<Removal>&)>& change, const widgets::Wording& what);
    void chooseRemoval(const std::string& since);
    void choosePairs();
    void remove();
    void setShowsFallen(std::optional<bool> shows);
    void chooseScope(ScopePart part);
    /// Reads polygons of a file and hands them over; what goes wrong is told.
    void readPolygons(const QString& path, const std::function<void(Outline)>& take);
    static QString polygonFiles();
    /// Changes what the case says of the current survey, as one undoable command.
    void edit(const std::function<void(CaseInput&)>& change, const widgets::Wording& what);
    void save();
    bool savable();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    SurveyWork& m_work;
    SurveyReach& m_reach;
    std::string m_removedSince;  ///< of what is being drawn
    SurveyPairs* m_pairs;
    SurveySections* m_sections;
};

}  // namespace rubble
