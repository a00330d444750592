#include "app/gui/dock_area.h"

#include <QDockWidget>

namespace rubble {

DockArea::DockArea(QWidget* parent) : QMainWindow(parent, Qt::Widget) {
    setObjectName(QStringLiteral("dockArea"));
    setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setContextMenuPolicy(Qt::PreventContextMenu);
}

QDockWidget* DockArea::addDock(QWidget* content, const QString& title, const QString& name) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setAccessibleName(title);
    dock->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    return dock;
}

}  // namespace rubble
