#pragma once

#include <QMainWindow>

namespace rubble {

/// What lies in the centre of the window with docks around it; timeline and status line keep their full width below.
class DockArea : public QMainWindow {
    Q_OBJECT

public:
    explicit DockArea(QWidget* parent = nullptr);

    /// Takes a widget into a dock that the user may move, float or close.
    QDockWidget* addDock(QWidget* content, const QString& title, const QString& name,
                         Qt::DockWidgetArea side = Qt::RightDockWidgetArea);
    /// From now on this dock floats over the centre wherever beside it the centre would become too narrow to work in. Where the
    /// user puts it holds until it is closed.
    void floatWhereNarrow(QDockWidget& dock);
    /// What floats over the views is in the way of a page that stands in front of them: it goes until they are back.
    void setViewsInFront(bool inFront);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    bool narrow() const;
    /// Where it covers no other dock, on the screen.
    QPoint freePlace() const;
    /// Moves it off a dock that has come.
    void makeWay();

    QDockWidget* m_floating = nullptr;
    bool m_floated = false;  ///< by this, not by the user
    QPoint m_place;          ///< where this has put it
    bool m_own = false;      ///< this moves it just now
    bool m_settled = false;  ///< the user has put it somewhere
    bool m_away = false;     ///< this has hidden it until the views are back
};

}  // namespace rubble
