#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QDBusConnection;

namespace rubble {

class MainWindow;

/// Tells a user who is elsewhere that long work has ended: the desktop draws attention to the window and shows what came of it.
class DoneNotice : public QObject {
    Q_OBJECT

public:
    /// Shows a line and what it is about outside the window.
    using Show = std::function<void(const QString& what, const QString& about)>;

    explicit DoneNotice(MainWindow& window);
    /// @param longMs  work that takes less is not told of, ms
    DoneNotice(MainWindow& window, int longMs, Show show);

private:
    /// What outlives the window.
    struct Kept {
        QElapsedTimer since;  ///< of the work that goes on
    };
    bool working() const;
    void look();
    void tell();

    MainWindow& m_window;
    const int m_longMs;
    Show m_show;
    Kept& m_kept;
    QElapsedTimer m_since;  // invalid: nothing goes on
    QTimer m_timer;
};

/// Sends a notification of the desktop (freedesktop.org, Desktop Notifications 1.2) without waiting for it; nothing happens where
/// the bus is not connected.
void notifyDesktop(const QDBusConnection& bus, const QString& what, const QString& about);

}  // namespace rubble
