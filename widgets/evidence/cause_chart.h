#pragma once

#include <QWidget>
#include <memory>

#include "core/evidence/ensembles/cause_comparison.h"
#include "widgets/basics/file_chart.h"

namespace rubble::widgets {

/// How close the members of every supposed cause come to the evidence: a row for each, the closest first, with a dot for each
/// member, its median, and from 5 to 95 % of its members.
class CauseChart : public QWidget, public FileChart {
    Q_OBJECT

public:
    explicit CauseChart(QWidget* parent = nullptr);

    /// Null: nothing is shown.
    void setComparison(std::shared_ptr<const CauseComparison> comparison);
    QSize sizeHint() const override { return {420, 240}; }
    /// As high as its rows need.
    QSize minimumSizeHint() const override;
    QString fileTitle() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;

private:
    void describe();

    std::shared_ptr<const CauseComparison> m_comparison;
};

/// "closest", "told apart" or "not told apart", of a cause by its place in the ranking.
QString standingWords(const CauseComparison& comparison, std::size_t rank);

}  // namespace rubble::widgets
