#pragma once

#include <QWidget>
#include <optional>

#include "widgets/basics/file_chart.h"

namespace rubble::widgets {

/// A chart of points that can be marked one at a time. Hovering a point tells its numbers; with the keyboard, Left, Right, Home and
/// End go from point to point. Where points can be chosen, a click, Enter or Space does that.
class PointChart : public QWidget, public FileChart {
    Q_OBJECT

public:
    /// Where a point lies, px of this widget.
    virtual QPointF placeOf(std::size_t point) const = 0;
    /// The point that the mouse is over or the keyboard has gone to.
    std::optional<std::size_t> marked() const { return m_marked; }

    QSize minimumSizeHint() const override { return {320, 220}; }

protected:
    /// @param markReach  px from the middle of a point to the frame that marks it
    PointChart(double markReach, QWidget* parent);

    virtual std::size_t pointCount() const = 0;
    virtual std::optional<std::size_t> pointAt(const QPointF& place) const = 0;
    /// All numbers of a point.
    virtual QString wordsOf(std::size_t point) const = 0;
    /// Said where no point is marked.
    virtual QString summary() const = 0;
    /// What a click on a point does, in words; empty: points cannot be chosen.
    virtual QString choosingWords() const { return {}; }
    virtual void choose(std::size_t point);

    /// The points are others now, and this one is marked among them.
    void setMarked(std::optional<std::size_t> point);
    /// Draws the frames of the marked point and of the focus.
    void paintMarks(QPainter& painter) const;

    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void describe();
    void mark(std::optional<std::size_t> point);
    QString tipOf(std::size_t point) const;
    /// The point that a key goes to; nothing for another key.
    std::optional<std::size_t> pointBy(int key) const;

    double m_markReach;
    std::optional<std::size_t> m_marked;
};

}  // namespace rubble::widgets
