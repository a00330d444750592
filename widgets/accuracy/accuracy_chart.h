#pragma once

#include "widgets/accuracy/accuracy_plot.h"
#include "widgets/basics/point_chart.h"

namespace rubble::widgets {

/// The chart of cost against accuracy; a point that is chosen becomes the setting of the case.
class AccuracyChart : public PointChart {
    Q_OBJECT

public:
    explicit AccuracyChart(QWidget* parent = nullptr);

    void setContent(PlotContent content);
    const PlotContent& content() const { return m_content; }
    QPointF placeOf(std::size_t point) const override;

    QSize sizeHint() const override { return {560, 400}; }
    QString fileTitle() const override;

signals:
    /// The setting of this row is to be used: number of a setting, or referenceRow.
    void rowChosen(int row);

protected:
    std::size_t pointCount() const override { return m_content.points.size(); }
    std::optional<std::size_t> pointAt(const QPointF& place) const override;
    QString wordsOf(std::size_t point) const override;
    QString summary() const override;
    QString choosingWords() const override;
    void choose(std::size_t point) override;
    void paintEvent(QPaintEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;

private:
    AccuracyPlot plot() const;

    PlotContent m_content;
};

}  // namespace rubble::widgets
