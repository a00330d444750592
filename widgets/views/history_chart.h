#pragma once

#include <QWidget>
#include <vector>

#include "core/evidence/maps/motion_history.h"
#include "widgets/basics/chart_axis.h"
#include "widgets/basics/file_chart.h"

namespace rubble::widgets {

/// Speed, height and energy of fragments over time, one field below the other. The instant of the timeline is a line through all;
/// clicking or dragging asks for another.
class HistoryChart : public QWidget, public FileChart {
    Q_OBJECT

public:
    struct Content {
        std::vector<HistoryPoint> points;  ///< in the order of time; heights as exported tables give them
        double from = 0.0;                 ///< s, of the whole timeline
        double to = 1.0;                   ///< s
        double timeOrigin = 0.0;           ///< s: what shown times count from
        QString subject;                   ///< whose history it is
    };

    explicit HistoryChart(QWidget* parent = nullptr);

    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    void setTime(double time);
    /// Where an instant lies, px of this widget; and the instant of a place.
    double placeOf(double time) const;
    double timeAt(double x) const;
    /// The frame at or before the instant shown; null before the first.
    const HistoryPoint* pointNow() const;
    /// The figures of that frame, in words.
    QString words() const;
    QSize sizeHint() const override { return {420, 320}; }
    QSize minimumSizeHint() const override { return {260, 200}; }
    QString fileTitle() const override;

signals:
    /// s
    void timeRequested(double time);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    void paintFile(QPainter& painter, const QRectF& area, const QFont& font) const override;

private:
    std::vector<ChartField> fieldsIn(const QRectF& area, const QFont& font) const;
    void paintChart(QPainter& painter, const QRectF& area, const QFont& font, const figures::Palette& palette) const;
    void ask(const QPointF& place);

    Content m_content;
    double m_time = 0.0;
};

}  // namespace rubble::widgets
