#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/session/worker.h"
#include "app/gui/studies/answer.h"
#include "core/fe/frame.h"
#include "core/scenario/case.h"
#include "io/site/clouds/octree/placed_octree.h"
#include "io/site/clouds/run_distance.h"
#include "widgets/render/basics/site_points.h"
#include "widgets/render/panes.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class SceneDisplay;
class Session;
class SurveyDisplay;
class ViewArea;

/// Points that views draw at most.
inline constexpr std::uint64_t pointsBudget = 1'500'000;

/// Reads points of clouds and measures their distances, whoever shows them.
class PointsWork : public QObject {
    Q_OBJECT

public:
    /// Where a cloud lies, and how.
    struct Cloud {
        std::string id;  ///< of the input
        std::string path;
        Frame frame;
        Site site;
        std::optional<Registration> placed;
        friend bool operator==(const Cloud&, const Cloud&) = default;
    };
    /// A cloud that is open, and what was read of it.
    struct Opened {
        std::unique_ptr<io::PlacedOctree> octree;
        std::pair<double, double> heights;  ///< m, of nearly all points
        render::PointColour colour = render::PointColour::Own;
        std::map<std::size_t, std::shared_ptr<const render::SitePoints::Patch>> read;
        std::map<int, render::Rgb> classes;  ///< that were met
    };
    /// From where it is looked at.
    struct Look {
        std::vector<std::pair<render::Pane, render::Camera>> panes;
        render::PointColour colour = render::PointColour::Own;
    };
    /// What distances are measured of.
    struct Measured {
        Cloud cloud;
        CaseInput survey;  ///< its scope without what had been removed by then
        std::shared_ptr<const void> run;
        CloudDistanceSettings settings;
        Findings said;  ///< of what the case says of the survey
        /// What can be chosen is the same.
        bool operator==(const Measured& other) const;
    };
    struct Distances {
        io::RunDistance made;
        std::vector<Vec3> cores;  ///< m, local
        double time = 0.0;        ///< s, on the file's clock, of the site
        /// Made when they are first drawn.
        std::shared_ptr<const render::SitePoints> points;
    };

    explicit PointsWork(QObject* parent = nullptr);

    void open(const Cloud& cloud);
    void close();
    void look(const Look& look);

    std::optional<Cloud> cloud;  ///< that is open or being opened
    std::shared_ptr<Opened> opened;
    std::optional<Failure> failure;
    std::shared_ptr<const render::SitePoints> points;
    bool whole = true;  ///< nothing was left out for the budget
    double fraction = 0.0;
    Answer<Measured, Distances> distances;
    std::shared_ptr<const Distances> making;  ///< what is measured is for this; null: for nobody any more
    Worker worker;
    Worker measuring;

signals:
    void changed();
};

/// Brings the points of the chosen cloud into the views: those that can be told apart on the screen, read in the background as the
/// camera goes. Which cloud, and what its colours say, is part of the view.
class CloudPoints : public QObject {
    Q_OBJECT

public:
    CloudPoints(Session& session, PanelDeck& deck, SceneDisplay& scene, SurveyDisplay& surveys, ViewArea& area, Actions& actions,
                QObject* parent = nullptr);
    ~CloudPoints() override;

    /// Draws the points of the chosen survey, or none.
    void setShown(bool shown);
    void setColour(render::PointColour colour);
    void measure();
    /// Adds the pictures of the chosen cloud that have a camera, as one undoable command.
    void addPhotographs();
    bool busy() const;
    void refresh();

signals:
    /// Points were asked for: the views are to be seen.
    void viewsRequested();

private:
    void stopMeasuring();
    void follow();
    void ask();
    /// Distances to the run at hand are drawn in place of the points.
    bool distancesShown() const;
    void publish();
    void showBox();
    bool isCloud(const CaseInput& input) const;
    std::optional<PointsWork::Cloud> cloudOf(const std::string& id) const;
    std::optional<PointsWork::Measured> measuredNow() const;
    int photographsOf(const CaseInput& survey);
    QString statusText() const;
    QString measuredText() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    SceneDisplay& m_scene;
    SurveyDisplay& m_surveys;
    ViewArea& m_area;
    Actions& m_actions;
    PointsWork& m_work;
    QTimer m_pause;  ///< from a move of the camera until points are asked for
    std::optional<std::pair<render::View, QSize>> m_asked;
    std::pair<std::string, int> m_pictures;  ///< with a camera, in the cloud of this path
};

}  // namespace rubble
