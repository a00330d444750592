#pragma once

#include <QWidget>
#include <optional>

#include "widgets/accuracy_plot.h"
#include "widgets/file_chart.h"

namespace rubble::widgets {

/// The chart of cost against accuracy. Hovering a point tells its numbers, a click chooses it; with the keyboard, Left and Right go
/// from point to point and Enter chooses.
class AccuracyChart : public QWidget, public FileChart {
    Q_OBJECT

public:
    explicit AccuracyChart(QWidget* parent = nullptr);

    void setContent(PlotContent content);
    const PlotContent& content() const { return m_content; }
    /// Where a point lies, px of this widget.
    QPointF placeOf(std::size_t point) const;
    /// The point that the mouse is over or the keyboard has gone to.
    std::optional<std::size_t> marked() const { return m_marked; }

    QSize sizeHint() const override { return {560, 400}; }
    QSize minimumSizeHint() const override { return {320, 220}; }

signals:
    /// The setting of this row is to be used: number of a setting, or referenceRow.
    void rowChosen(int row);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;
    QString fileTitle() const override;

private:
    AccuracyPlot plot() const;
    void mark(std::optional<std::size_t> point);
    void describe();

    PlotContent m_content;
    std::optional<std::size_t> m_marked;
};

}  // namespace rubble::widgets
