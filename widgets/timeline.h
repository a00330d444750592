#pragma once

#include <QWidget>
#include <vector>

namespace rubble::widgets {

/// Deaths over time as an area, what is computed as a bar that grows, the end of the FE result as a dashed line, one playhead.
/// Emits scrubbed() while the mouse drags. Times in s.
class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(QWidget* parent = nullptr);

    /// The span of the axis.
    void setRange(double first, double last);
    /// Elements that died in the interval that ends at each state.
    void setDeaths(std::vector<double> times, std::vector<double> deaths);
    void setFeEnd(double time);
    /// What is computed; empty (last <= first) for nothing.
    void setComputed(double first, double last, bool stale);
    void setTime(double time);

    double time() const { return m_time; }
    /// Place of a time on the axis and back [px].
    double toX(double time) const;
    double toTime(double x) const;
    QSize sizeHint() const override { return {600, 112}; }
    QSize minimumSizeHint() const override { return {240, 96}; }

signals:
    void scrubbed(double time);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    struct Rows;
    Rows rows() const;
    void paintDeaths(QPainter& painter, const Rows& rows) const;
    void paintComputed(QPainter& painter, const Rows& rows) const;
    void paintAxis(QPainter& painter, const Rows& rows) const;
    void paintMarks(QPainter& painter, const Rows& rows) const;

    double m_first = 0.0;
    double m_last = 0.0;
    std::vector<double> m_times;
    std::vector<double> m_deaths;
    double m_feEnd = 0.0;
    double m_computedFirst = 0.0;
    double m_computedLast = 0.0;
    bool m_stale = false;
    double m_time = 0.0;
};

/// A round step (1, 2 or 5 times a power of ten) that puts at most `count` marks over `span`.
double roundStep(double span, double count);

}  // namespace rubble::widgets
