#include "app/gui/window/window_focus.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QTimer>

namespace rubble {

namespace {

/// Once what is being shown or closed is done with; another dialog that is modal keeps the keyboard, or what it has opened itself.
void activateSoon(QWidget* window) {
    QTimer::singleShot(0, window, [window] {
        const QWidget* modal = QApplication::activeModalWidget();
        const bool taken = modal != nullptr && modal != window && modal != window->parentWidget();
        if (window->isVisible() && !window->isActiveWindow() && !taken) {
            window->activateWindow();
        }
    });
}

}  // namespace

WindowFocus::WindowFocus(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool WindowFocus::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::Show || type == QEvent::Hide) {
        if (auto* dialog = qobject_cast<QDialog*>(watched); dialog != nullptr && dialog->isWindow()) {
            if (type == QEvent::Show) {
                activateSoon(dialog);
            } else if (const QWidget* active = QApplication::activeWindow();
                       dialog->parentWidget() != nullptr && (active == nullptr || active == dialog)) {
                activateSoon(dialog->parentWidget()->window());
            }
        }
    } else if (type == QEvent::MouseButtonPress) {
        auto* widget = qobject_cast<QWidget*>(watched);
        if (widget != nullptr && !widget->window()->isActiveWindow() && widget->window()->windowType() != Qt::Popup) {
            activateSoon(widget->window());
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble
