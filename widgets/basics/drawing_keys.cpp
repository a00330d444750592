#include "widgets/basics/drawing_keys.h"

#include <QKeyEvent>

namespace rubble::widgets {

bool keepsDrawingKeys(QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride) {
        return false;
    }
    switch (static_cast<QKeyEvent&>(event).key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Space:
        case Qt::Key_Escape:
            event.accept();
            return true;
        default:
            return false;
    }
}

}  // namespace rubble::widgets
