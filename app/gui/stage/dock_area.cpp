#include "app/gui/stage/dock_area.h"

#include <QDockWidget>
#include <algorithm>
#include <utility>

namespace rubble {

namespace {

// px: two views side by side are still wide enough to see a collapse.
constexpr int usableWidth = 640;
constexpr int margin = 12;
constexpr QSize floatingSize(300, 600);

}  // namespace

DockArea::DockArea(QWidget* parent) : QMainWindow(parent, Qt::Widget) {
    setObjectName(QStringLiteral("dockArea"));
    setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setContextMenuPolicy(Qt::PreventContextMenu);
}

QDockWidget* DockArea::addDock(QWidget* content, const QString& title, const QString& name, Qt::DockWidgetArea side) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setAccessibleName(title);
    dock->setWidget(content);
    addDockWidget(side, dock);
    dock->hide();
    // Once what comes or goes has its place.
    connect(dock, &QDockWidget::visibilityChanged, this, &DockArea::makeWay, Qt::QueuedConnection);
    return dock;
}

void DockArea::floatWhereNarrow(QDockWidget& dock) {
    m_floating = &dock;
    dock.setAttribute(Qt::WA_ShowWithoutActivating);
    connect(&dock, &QDockWidget::visibilityChanged, this, [this] {
        m_settled = m_settled && !m_floating->isHidden();
        arrange();
    });
    connect(&dock, &QDockWidget::topLevelChanged, this, [this] { m_settled = m_settled || !m_own; });
}

bool DockArea::narrow() const {
    int beside = std::max(m_floating->widget()->sizeHint().width(), m_floating->minimumSizeHint().width());
    for (const QDockWidget* other : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        const bool below = dockWidgetArea(const_cast<QDockWidget*>(other)) == Qt::BottomDockWidgetArea;
        const bool shares = below || tabifiedDockWidgets(m_floating).contains(const_cast<QDockWidget*>(other));
        if (other != m_floating && other->isVisible() && !other->isFloating() && !shares) {
            // Docks of one side stand one above the other.
            beside = std::max(beside, other->width());
        }
    }
    return width() - beside < usableWidth;
}

void DockArea::arrange() {
    // A dock that is taken out or put back says more than once that it is to be seen.
    if (m_own || m_floating == nullptr || m_floating->isHidden() || m_settled || !isVisible()) {
        return;
    }
    m_own = true;
    if (narrow() && !m_floating->isFloating()) {
        m_floating->setFloating(true);
        m_floated = true;
        const QSize size(std::min(floatingSize.width(), width() - 2 * margin),
                         std::min(floatingSize.height(), height() - 2 * margin));
        m_floating->resize(size);
        m_floating->move(freePlace());
        m_place = m_floating->pos();
    } else if (!narrow() && m_floating->isFloating() && m_floated) {
        m_floating->setFloating(false);
        m_floated = false;
    }
    m_own = false;
}

QPoint DockArea::freePlace() const {
    int right = width();
    for (const QDockWidget* other : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        const bool atRight = dockWidgetArea(const_cast<QDockWidget*>(other)) == Qt::RightDockWidgetArea;
        if (other != m_floating && atRight && other->isVisible() && !other->isFloating()) {
            right = std::min(right, other->x());
        }
    }
    return mapToGlobal(QPoint(std::max(margin, right - margin - m_floating->width()), margin));
}

void DockArea::makeWay() {
    // Where the user has moved it, it stays.
    if (m_floating == nullptr || !m_floated || m_settled || !m_floating->isVisible() || m_floating->pos() != m_place) {
        return;
    }
    m_floating->move(freePlace());
    m_place = m_floating->pos();
}

void DockArea::setViewsInFront(bool inFront) {
    if (inFront && std::exchange(m_away, false)) {
        m_floating->show();
    } else if (!inFront && m_floating != nullptr && m_floated && !m_settled && !m_floating->isHidden()) {
        m_away = true;
        m_floating->hide();
    }
}

void DockArea::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    arrange();
}

}  // namespace rubble
