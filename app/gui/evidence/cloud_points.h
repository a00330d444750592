#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/gui/evidence/points_work.h"
#include "io/case/case_photographs.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class SceneDisplay;
class Session;
class SurveyDisplay;
class ViewArea;

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
    /// Writes the measured distances as LAS, PLY or CSV, by the ending; nothing while they are of something else.
    void saveDistancesTo(const QString& path);
    /// Adds the pictures of the chosen cloud that have a camera, read in the background, as one undoable command.
    void addPhotographs();
    void stopPhotographs();
    bool busy() const;
    void refresh();

signals:
    /// Points were asked for: the views are to be seen.
    void viewsRequested();

private:
    void stopMeasuring();
    void takePhotographs();
    void showAdded(const io::AddedPhotographs& added, Case&& theCase, const Findings& findings);
    void follow();
    void ask();
    /// Distances to the run at hand are drawn in place of the points.
    bool distancesShown() const;
    bool distancesKept() const;
    void saveDistances();
    void publish();
    void showBox();
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
