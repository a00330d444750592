#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/gui/window/options.h"

namespace rubble {

class MainWindow;

/// Wall time since this process was started, its libraries included, s; to 10 ms. 0 if the system does not say.
double secondsSinceStart();

/// Opens a file in the window as a user would, measures how long that and scrubbing take and prints one JSON object. Begins when
/// the window is painted for the first time.
class SpeedMeasure : public QObject {
    Q_OBJECT

public:
    /// @param options  the file, and whether to simulate it and scrub over the run as well
    SpeedMeasure(MainWindow& window, const Options& options);

signals:
    /// 0, or 1 if the file cannot be opened.
    void finished(int exitCode);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void begin();
    void look();
    void report();
    /// Goes to each instant [s] and waits until it is drawn; wall times, ms.
    std::vector<double> scrub(const std::vector<double>& times);
    /// Instants [s] from the first to the last one that can be shown, always the same ones.
    std::vector<double> instants() const;

    MainWindow& m_window;
    const Options m_options;
    QTimer m_timer;
    QElapsedTimer m_opening;
    std::optional<double> m_firstWindow;
    std::optional<double> m_firstPicture;
    std::optional<double> m_prepared;
    bool m_simulating = false;
};

}  // namespace rubble
