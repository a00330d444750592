#pragma once

#include <QMainWindow>

namespace rubble {

/// What lies in the centre of the window with docks around it; timeline and status line keep their full width below.
class DockArea : public QMainWindow {
    Q_OBJECT

public:
    explicit DockArea(QWidget* parent = nullptr);

    /// Takes a widget into a dock at the right that the user may move, float or close.
    QDockWidget* addDock(QWidget* content, const QString& title, const QString& name);
};

}  // namespace rubble
