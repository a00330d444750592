#pragma once

#include <QTableWidget>
#include <memory>
#include <optional>

#include "core/analysis/accuracy/accuracy_study.h"
#include "widgets/accuracy/accuracy_plot.h"

namespace rubble::widgets {

/// The settings of a sweep as a table: the reference, the repeat floor, and each setting, done or not. Enter or a double click
/// chooses a setting.
class AccuracyTable : public QTableWidget {
    Q_OBJECT

public:
    explicit AccuracyTable(QWidget* parent = nullptr);

    void setReport(const AccuracyReport& report, std::optional<int> inUse);
    /// The columns of these two figures stand first.
    void bringForward(CostKind cost, const AccuracyKind& accuracy);
    QSize sizeHint() const override { return {380, 240}; }

signals:
    /// The setting of this row is to be used: number of a setting, or referenceRow.
    void rowChosen(int row);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void setHeadings(const std::vector<double>& tolerances);
    void addPoint(const AccuracyPoint& point, int row, bool inUse);
    void addFloor(const AccuracyReport& report);
    void choose(int line);
    void put(int line, int column, const QString& text, const QString& tip = {});

    std::vector<AccuracyKind> m_kinds;
};

}  // namespace rubble::widgets
