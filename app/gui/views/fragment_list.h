#pragma once

#include <QObject>
#include <QTimer>

#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"

class QDockWidget;

namespace rubble {

class Playback;
class SelectionDisplay;
class ViewArea;
namespace widgets {
class FragmentTable;
}

/// Keeps the table of fragments with the views: what is selected in one is selected in the other, bounds set in the table leave
/// fragments out of the views, and speeds follow the time shown.
class FragmentList : public QObject {
    Q_OBJECT

public:
    FragmentList(Playback& playback, ViewArea& area, SelectionDisplay& selection, widgets::FragmentTable& table, QDockWidget& dock,
                 QObject* parent = nullptr);

    /// Another result, run or view is shown.
    void refresh();
    /// A view with other bounds was opened.
    void showFilter();

private:
    const render::SceneData& data() const;
    bool seen() const;
    void setFilter(const render::FragmentFilter& filter);
    void takeSpeeds();

    Playback& m_playback;
    ViewArea& m_area;
    SelectionDisplay& m_selection;
    widgets::FragmentTable& m_table;
    QDockWidget& m_dock;
    QTimer m_rest;  ///< speeds are taken so often at most
};

}  // namespace rubble
