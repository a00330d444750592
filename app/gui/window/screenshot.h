#pragma once

#include <QObject>
#include <QTimer>

#include "app/gui/window/options.h"

namespace rubble {

class MainWindow;
struct Failure;

/// Takes a picture of the window once what was asked for is there (opened, and simulated if the window was told to), saves it and
/// leaves the program: exit code 0, or 1 if something failed. Where an action asks something in a dialog, the picture shows it.
class Screenshot : public QObject {
    Q_OBJECT

public:
    /// @param options  where to, which instant and panel, and whether to wait for a run to end
    Screenshot(MainWindow& window, const Options& options);

private:
    void look();
    void prepare();
    void watchDialogs();
    void giveUp(const Failure& failure);
    void take();

    MainWindow& m_window;
    const Options m_options;
    QTimer m_timer;
    QTimer m_dialogs;
    int m_dialogSeen = 0;  // looks in a row
    bool m_prepared = false;
    bool m_taken = false;
};

}  // namespace rubble
