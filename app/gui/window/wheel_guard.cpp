#include "app/gui/window/wheel_guard.h"

#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QTabBar>

namespace rubble {

namespace {

/// ms. Turns of the wheel that follow each other faster are one scroll.
constexpr qint64 oneScroll = 300;
/// Property of a window in which nothing was pressed since it was shown.
constexpr const char* untouched = "rubbleUntouched";

/// Whose value or page the wheel changes.
bool changesByWheel(const QWidget& widget) {
    return qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QTabBar*>(&widget) != nullptr ||
           (qobject_cast<const QAbstractSlider*>(&widget) != nullptr && qobject_cast<const QScrollBar*>(&widget) == nullptr);
}

bool isViewport(const QWidget& widget) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
    return area != nullptr && area->viewport() == &widget;
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool WheelGuard::passesBy(const QWidget& widget) const {
    if (!changesByWheel(widget)) {
        return false;
    }
    return !widget.hasFocus() || widget.window()->property(untouched).toBool() ||
           (m_scrolled.isValid() && m_scrolled.elapsed() < oneScroll);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr) {
        return QObject::eventFilter(watched, event);
    }
    const bool comes = event->type() == QEvent::Polish || event->type() == QEvent::Show;
    if (comes && widget->focusPolicy() == Qt::WheelFocus) {
        widget->setFocusPolicy(Qt::StrongFocus);
    }
    if (event->type() == QEvent::Show && widget->isWindow()) {
        widget->setProperty(untouched, true);
    } else if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) {
        widget->window()->setProperty(untouched, false);
    } else if (event->type() == QEvent::FocusIn) {
        m_scrolled.invalidate();  // what is chosen now is meant
    } else if (event->type() == QEvent::Wheel && passesBy(*widget)) {
        // Left to what the widget stands in.
        event->ignore();
        return true;
    } else if (event->type() == QEvent::Wheel && isViewport(*widget)) {
        m_scrolled.start();
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble
