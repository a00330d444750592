#pragma once

#include <QWidget>
#include <memory>

#include "widgets/accuracy/calibration_plot.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace rubble::widgets {

class CalibrationChart;
class FindingList;
class Notice;
class ProgressLabel;

/// What this machine carries: the curve of live FPS against the number of bodies, and the button that measures it.
class CalibrationView : public QWidget {
    Q_OBJECT

public:
    explicit CalibrationView(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const Calibration> calibration;  ///< null: this machine was not measured yet
        CalibrationPlotContent plot;
        std::int64_t bodiesMax = 0;  ///< that the case allows; 0: no case is open
        bool running = false;
        QString why;  ///< it cannot be started now; empty: it can
    };
    void setContent(const Content& content);
    /// @param secondsLeft  NaN: not known yet
    void setProgress(double fraction, double secondsLeft);
    void setError(const QString& what, const QString& remedy = {});
    CalibrationChart& chart() { return *m_chart; }

signals:
    void calibrateRequested();
    void cancelRequested();
    /// The case is to allow so many bodies.
    void bodiesChosen(std::int64_t bodies);
    void saveTableRequested();
    void saveChartRequested();

private:
    QWidget* buildButtons();
    void showFacts(const Content& content);

    QLabel* m_sentence;
    Notice* m_notice;
    CalibrationChart* m_chart;
    QLabel* m_facts;
    QPushButton* m_calibrate;
    QPushButton* m_cancel;
    QPushButton* m_use;
    QPushButton* m_saveTable;
    QPushButton* m_saveChart;
    QProgressBar* m_bar;
    ProgressLabel* m_progress;
    FindingList* m_findings;
    std::int64_t m_offered = 0;
    bool m_failed = false;
};

}  // namespace rubble::widgets
