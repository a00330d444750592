#pragma once

#include "widgets/accuracy/calibration_plot.h"
#include "widgets/basics/point_chart.h"

namespace rubble::widgets {

/// The chart of live FPS against the number of bodies.
class CalibrationChart : public PointChart {
    Q_OBJECT

public:
    explicit CalibrationChart(QWidget* parent = nullptr);

    void setContent(CalibrationPlotContent content);
    const CalibrationPlotContent& content() const { return m_content; }
    QPointF placeOf(std::size_t point) const override;

    QSize sizeHint() const override { return {640, 420}; }
    QString fileTitle() const override;

protected:
    std::size_t pointCount() const override { return m_content.points.size(); }
    std::optional<std::size_t> pointAt(const QPointF& place) const override;
    QString wordsOf(std::size_t point) const override;
    QString summary() const override;
    void paintEvent(QPaintEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;

private:
    CalibrationPlot plot() const;

    CalibrationPlotContent m_content;
};

}  // namespace rubble::widgets
