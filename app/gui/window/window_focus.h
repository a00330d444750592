#pragma once

#include <QObject>

namespace rubble {

/// Gives the keyboard to the window that is shown or clicked last, and back to the one behind when it closes. Window managers do so
/// themselves; on a bare X server keys would go on to the main window while somebody types into a dialog.
class WindowFocus : public QObject {
    Q_OBJECT

public:
    explicit WindowFocus(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace rubble
