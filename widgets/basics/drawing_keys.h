#pragma once

class QEvent;

namespace rubble::widgets {

/// Keeps the keys by which something is drawn (arrows, Space, Escape) from the shortcuts of the window, where they are the
/// transport's. For event() of a view while it draws: true if the event was one of them, which is then accepted.
bool keepsDrawingKeys(QEvent& event);

}  // namespace rubble::widgets
