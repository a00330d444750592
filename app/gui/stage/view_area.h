#pragma once

#include <QStackedWidget>

#include "widgets/basics/panel.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace widgets {
class ClipBar;
class ErrorBar;
class ScenarioBar;
class StartPage;
}  // namespace widgets

/// The centre of the window: the views, the start page while nothing is open, or why there is nothing to view.
class ViewArea : public QStackedWidget {
    Q_OBJECT

public:
    explicit ViewArea(QWidget* parent = nullptr);

    widgets::ViewWidget& views() { return *m_views; }
    /// What the keys and the menu of the camera move: the views, or the model beside a photograph while that is seen.
    widgets::ViewWidget& watched();
    /// Names the view of the model that stands beside a photograph, in place of the views.
    void setBesidePhotograph(widgets::ViewWidget& model) { m_besidePhotograph = &model; }
    /// Stands above the views while fragments are coloured by their error.
    widgets::ErrorBar& errorBar() { return *m_errorBar; }
    /// Stands above the views while another scenario is shown in one.
    widgets::ScenarioBar& scenarioBar() { return *m_scenarioBar; }
    widgets::StartPage& startPage() { return *m_start; }
    /// Stands below the views while they are cut.
    widgets::ClipBar& clipBar() { return *m_clipBar; }
    /// @param open  a case is open; without views the centre says why there are none
    void showViews(bool show, bool open = false);
    /// An error in place of the views; an empty text removes it.
    void setError(const QString& what, const QString& remedy = {});
    /// "Opening ..." while a file is read.
    void setActivity(const QString& what);

private:
    QWidget* buildEmpty();

    widgets::StartPage* m_start;
    widgets::ViewWidget* m_views;
    widgets::ViewWidget* m_besidePhotograph = nullptr;
    widgets::ErrorBar* m_errorBar;
    widgets::ScenarioBar* m_scenarioBar;
    widgets::ClipBar* m_clipBar;
    widgets::Notice* m_error;
    QLabel* m_activity;
};

}  // namespace rubble
