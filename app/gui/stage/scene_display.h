#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"

class QComboBox;

namespace rubble {

class Actions;
class Computation;
class Document;
class Playback;
class Session;
class ViewArea;

/// What the views of a window show: model and run, and how they are looked at. The view outlives the window.
class SceneDisplay : public QObject {
    Q_OBJECT

public:
    /// @param colours  chooses what the colour of a fragment says
    SceneDisplay(Session& session, Playback& playback, ViewArea& area, Actions& actions, QComboBox& colours,
                 QObject* parent = nullptr);
    ~SceneDisplay() override;

    /// What is there to be shown.
    render::SceneData data() const;
    /// Hands it to the views if it has changed.
    void show();
    /// Shows in a new window what an earlier one showed.
    void goOn();
    void setView(const render::View& view);
    /// What the elements of the views look like now.
    render::Style style() const;
    /// Looks at the model as a saved view does; the theme stays.
    void look(render::View view);
    /// The whole model as it is seen first; colours and style stay as they are.
    void lookAtAll();
    /// What fragments are compared with; null: nothing.
    void setReference(std::shared_ptr<const TrajectoryReader> reference);
    /// The loose structure of the FE result that is open, told apart by colours; null: none.
    void setLoose(std::shared_ptr<const LooseStructure> loose);
    /// What lies on the ground in place of the orthophoto; null: nothing.
    void setGround(std::shared_ptr<const Orthophoto> ground);
    /// Points of a cloud; null: none.
    void setPoints(std::shared_ptr<const render::SitePoints> points);
    /// The colours of the theme that is in force.
    void useTheme();

signals:
    /// Another model or another run is shown.
    void changed();
    void viewSet(const rubble::render::View& view);

private:
    /// What outlives the window.
    struct Kept {
        std::optional<render::View> view;
        std::array<bool, render::paneCameras> moved{};  ///< as ViewWidget::moved()
    };
    void connectActions();
    void setLayout(render::Layout layout);
    /// That of Preferences, with which views begin.
    render::Style preferredStyle() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Playback& m_playback;
    ViewArea& m_area;
    Actions& m_actions;
    QComboBox& m_colours;
    Kept& m_kept;
    std::shared_ptr<const TrajectoryReader> m_reference;
    std::shared_ptr<const LooseStructure> m_loose;
    std::weak_ptr<const FeResult> m_looseOf;
    std::shared_ptr<const Orthophoto> m_ground;
    std::shared_ptr<const render::SitePoints> m_points;
    render::SceneData m_shown;
};

}  // namespace rubble
