#pragma once

#include <QWidget>
#include <optional>

#include "widgets/calibration_plot.h"
#include "widgets/file_chart.h"

namespace rubble::widgets {

/// The chart of live FPS against the number of bodies. Hovering a point tells its numbers; with the keyboard, Left and Right go
/// from point to point.
class CalibrationChart : public QWidget, public FileChart {
    Q_OBJECT

public:
    explicit CalibrationChart(QWidget* parent = nullptr);

    void setContent(CalibrationPlotContent content);
    const CalibrationPlotContent& content() const { return m_content; }
    /// Where a point lies, px of this widget.
    QPointF placeOf(std::size_t point) const;
    /// The point that the mouse is over or the keyboard has gone to.
    std::optional<std::size_t> marked() const { return m_marked; }

    QSize sizeHint() const override { return {640, 420}; }
    QSize minimumSizeHint() const override { return {320, 220}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;
    QString fileTitle() const override;

private:
    CalibrationPlot plot() const;
    void mark(std::optional<std::size_t> point);
    void describe();

    CalibrationPlotContent m_content;
    std::optional<std::size_t> m_marked;
};

}  // namespace rubble::widgets
