#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

namespace rubble {

class MainWindow;

/// Takes a picture of the window once what was asked for is there (opened, and simulated if the window was told to), saves it and
/// leaves the program: exit code 0, or 1 if something failed.
class Screenshot : public QObject {
    Q_OBJECT

public:
    /// @param simulated  waits for the run to end
    Screenshot(MainWindow& window, QString path, std::optional<double> time, bool simulated);

private:
    void look();
    void take();

    MainWindow& m_window;
    QString m_path;
    std::optional<double> m_time;
    bool m_simulated;
    QTimer m_timer;
};

}  // namespace rubble
