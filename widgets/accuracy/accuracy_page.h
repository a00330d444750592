#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/analysis/accuracy/accuracy_study.h"
#include "widgets/accuracy/accuracy_plot.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QButtonGroup;

namespace rubble::widgets {

class AccuracyChart;
class AccuracyTable;
class Notice;

/// What accuracy costs: the chart, what its axes are, and the table of the same settings beside it.
class AccuracyPage : public QWidget {
    Q_OBJECT

public:
    explicit AccuracyPage(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const AccuracyReport> report;  ///< null: nothing was compared yet
        std::optional<int> inUse;                      ///< the row that is the current setting
        double fpsTarget = 24.0;
        bool stale = false;    ///< compared under other settings of the case
        bool running = false;  ///< points are still coming
    };
    void setContent(const Content& content);
    AccuracyChart& chart() { return *m_chart; }
    AccuracyTable& table() { return *m_table; }
    /// Chooses a cost, as a click on its button; until then one that is known is taken, the bodies if no other is.
    void setCost(CostKind kind);
    void setAccuracy(const AccuracyKind& kind);

signals:
    /// The setting of this row is to be used: number of a setting, or referenceRow.
    void rowChosen(int row);
    void saveTableRequested();
    void saveChartRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildChoices();
    QWidget* buildTable();
    void fillKinds();
    void takeKnownCost();
    void showPlot();
    AccuracyKind accuracy() const;

    Content m_content;
    std::vector<AccuracyKind> m_kinds;
    CostKind m_cost = CostKind::StepMean;
    bool m_costChosen = false;
    QComboBox* m_accuracy;
    QButtonGroup* m_costs;
    QLabel* m_sentence;
    Notice* m_notice;
    AccuracyChart* m_chart;
    QLabel* m_left;
    QLabel* m_runs;
    AccuracyTable* m_table;
    QPushButton* m_saveTable;
    QPushButton* m_saveChart;
    QSplitter* m_splitter;
};

}  // namespace rubble::widgets
