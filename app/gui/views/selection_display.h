#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/trajectory/island_times.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/views/inspector.h"
#include "widgets/views/select_form.h"

namespace rubble {

class Computation;
class Session;
class Playback;
class ViewArea;

/// What is selected in the views: tells the Inspector, reads the way of a selected fragment behind the window's back, and hides,
/// isolates, grows and exports the selection.
class SelectionDisplay : public QObject {
    Q_OBJECT

public:
    SelectionDisplay(Session& session, Playback& playback, ViewArea& area, widgets::Inspector& inspector, widgets::SelectForm& form,
                     QObject* parent = nullptr);

    const std::vector<ElementIndex>& selection() const;
    void select(std::vector<ElementIndex> elements);
    void clear() { select({}); }
    /// What the criteria of the form name: takes the place of the selection, adds to it or is taken out of it.
    void selectBy(const widgets::SelectForm::Criteria& criteria);
    /// All that moves in the clusters of what is selected; all of its components.
    void growToClusters();
    void growToComponents();
    void hide();
    void isolate();
    /// To the last active state of the selected element, with it in the middle.
    void goToBirth();
    void follow(bool follow);
    /// The fragments of the selection, ascending.
    std::vector<FragmentId> fragments() const;
    /// Another result, run or reference is shown.
    void refresh();
    /// The way of the selected fragment is being read.
    bool reading() const { return m_reading; }

signals:
    /// There is something selected now, or nothing any more.
    void changed(bool something);

private:
    struct Way;
    /// What outlives the window.
    struct Kept {
        bool follow = false;
    };
    const render::SceneData& data() const;
    void show();
    bool dropUnknown();
    void showTime(double time);
    widgets::Inspector::ElementFacts factsOf(ElementIndex element) const;
    widgets::Inspector::FragmentFacts factsOf(FragmentId fragment) const;
    widgets::Inspector::Sums sums() const;
    void readWay();
    void takeWay(const std::shared_ptr<Way>& way);
    std::optional<FragmentId> fragmentOf(ElementIndex element) const;
    void indexFragments();
    void indexIslands();
    void setPath(std::vector<Vec3> path);

    Session& m_session;
    Computation& m_computation;
    Playback& m_playback;
    ViewArea& m_area;
    widgets::Inspector& m_inspector;
    widgets::SelectForm& m_form;
    std::shared_ptr<const FragmentSet> m_indexed;
    std::vector<std::uint32_t> m_fragmentOf;              ///< by element; the last of those that come back to life
    std::shared_ptr<const TrajectoryReader> m_islandsOf;  ///< what m_islands is of, with this many frames
    std::size_t m_islandFrames = 0;
    IslandTimes m_islands;
    std::shared_ptr<Way> m_way;  ///< of the one fragment that is selected
    bool m_reading = false;
    bool& m_follow;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
