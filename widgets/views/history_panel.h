#pragma once

#include <QWidget>

#include "widgets/views/history_chart.h"

class QLabel;
class QPushButton;

namespace rubble::widgets {

class Notice;

/// The chart of a history with whose it is, its figures at the instant shown, and a way to save them.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(QWidget* parent = nullptr);

    HistoryChart& chart() { return *m_chart; }
    /// @param why  there are no curves; empty: there are, or they are being read
    void setContent(const HistoryChart::Content& content, const QString& why, bool reading);
    void setTime(double time);
    /// What stands below the chart.
    QString words() const;
    QSize sizeHint() const override { return {460, 420}; }

signals:
    void saveTableRequested();
    void saveChartRequested();

private:
    QLabel* m_subject;
    QPushButton* m_saveTable;
    QPushButton* m_saveChart;
    Notice* m_notice;
    HistoryChart* m_chart;
    QLabel* m_words;
};

}  // namespace rubble::widgets
