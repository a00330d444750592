#include "widgets/figures/report/report_chart.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/round_step.h"
#include "widgets/figures/sheets/sheet_text.h"

namespace rubble::figures {
namespace {

/// Places a chart in its area and paints it.
class ChartSheet {
public:
    ChartSheet(const ReportChart& chart, const QRectF& area, double text)
        : m_chart(chart), m_text(text), m_left(area.left()), m_palette(palette(chart.theme)) {
        m_font = sheetFont(text);
        findRange();
        const QFontMetricsF metrics(m_font);
        m_plot =
            area.adjusted(metrics.horizontalAdvance(QStringLiteral("000,000")) + 0.8 * text, 2.0 * text, -7.5 * text, -3.6 * text);
    }

    void paint(QPainter& painter) {
        painter.setFont(m_font);
        paintBand(painter);
        paintAxes(painter);
        for (const ChartSeries& series : m_chart.series) {
            paintSeries(painter, series);
        }
    }

private:
    double axis(double x) const { return m_chart.logX ? std::log10(std::max(x, 1e-12)) : x; }

    void findRange() {
        m_low = {INFINITY, m_chart.fromZero ? 0.0 : INFINITY};
        m_high = {-INFINITY, -INFINITY};
        for (const ChartSeries& series : m_chart.series) {
            for (const ChartSeries::Point& point : series.points) {
                m_low = {std::min(m_low.x(), axis(point.x)), std::min(m_low.y(), point.y)};
                m_high = {std::max(m_high.x(), axis(point.x)), std::max(m_high.y(), point.y)};
            }
        }
        if (std::isfinite(m_chart.band)) {
            m_high.setY(std::max(m_high.y(), m_chart.band));
        }
        if (!(m_low.x() < m_high.x())) {
            const double middle = std::isfinite(m_low.x()) ? m_low.x() : 0.0;
            m_low.setX(middle - 0.5);
            m_high.setX(middle + 0.5);
        }
        if (!(m_low.y() < m_high.y())) {
            m_low.setY(std::isfinite(m_low.y()) ? m_low.y() : 0.0);
            m_high.setY(m_low.y() + 1.0);
        }
        if (m_chart.logX) {
            const double margin = 0.06 * (m_high.x() - m_low.x());
            m_low.setX(m_low.x() - margin);
            m_high.setX(m_high.x() + margin);
        }
        m_high.setY(m_high.y() + 0.06 * (m_high.y() - m_low.y()));
    }

    QPointF at(double x, double y) const {
        return {m_plot.left() + (axis(x) - m_low.x()) / (m_high.x() - m_low.x()) * m_plot.width(),
                m_plot.bottom() - (y - m_low.y()) / (m_high.y() - m_low.y()) * m_plot.height()};
    }
    double thin() const { return std::max(0.5, 0.06 * m_text); }

    void paintBand(QPainter& painter) {
        if (!std::isfinite(m_chart.band)) {
            return;
        }
        const double y = at(1.0, m_chart.band).y();
        painter.fillRect(QRectF(QPointF(m_plot.left(), y), m_plot.bottomRight()), m_palette.findingTint);
        painter.setPen(m_palette.muted);
        painter.drawText(QRectF(m_plot.right() + 0.4 * m_text, y - 0.7 * m_text, 7.0 * m_text, 3.0 * m_text),
                         static_cast<int>(Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap), m_chart.bandName);
    }

    void paintAxes(QPainter& painter) {
        painter.setPen(QPen(m_palette.muted, thin()));
        painter.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        painter.drawLine(m_plot.bottomLeft(), m_plot.topLeft());
        const double step = roundStep(m_high.y() - m_low.y(), 5);
        for (double y = step * std::ceil(m_low.y() / step - 1e-9); y <= m_high.y(); y += step) {
            const double height = at(1.0, y).y();
            painter.setPen(QPen(m_palette.hairline, thin()));
            painter.drawLine(QPointF(m_plot.left(), height), QPointF(m_plot.right(), height));
            painter.setPen(m_palette.text);
            painter.drawText(QRectF(m_plot.left() - 10.4 * m_text, height - m_text, 10.0 * m_text, 2.0 * m_text),
                             static_cast<int>(Qt::AlignRight | Qt::AlignVCenter),
                             numberText(std::abs(y) < 1e-12 * step ? 0.0 : y, std::max(4, digitsOfMark(y, step))));
        }
        const std::vector<double> marks = marksAlong();
        const double apart = m_chart.logX || marks.size() < 2 ? 0.0 : marks[1] - marks[0];
        for (const double x : marks) {
            const double place = at(x, 0.0).x();
            painter.setPen(QPen(m_palette.muted, thin()));
            painter.drawLine(QPointF(place, m_plot.bottom()), QPointF(place, m_plot.bottom() + 0.3 * m_text));
            painter.setPen(m_palette.text);
            painter.drawText(QRectF(place - 5.0 * m_text, m_plot.bottom() + 0.4 * m_text, 10.0 * m_text, 1.5 * m_text),
                             static_cast<int>(Qt::AlignCenter), numberText(x, std::max(4, digitsOfMark(x, apart))));
        }
        painter.drawText(QRectF(m_plot.left(), m_plot.bottom() + 2.0 * m_text, m_plot.width(), 1.6 * m_text),
                         static_cast<int>(Qt::AlignCenter), m_chart.xTitle);
        painter.drawText(QRectF(m_left, m_plot.top() - 2.0 * m_text, 40.0 * m_text, 1.6 * m_text),
                         static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), m_chart.yTitle);
    }

    std::vector<double> marksAlong() const {
        std::vector<double> marks;
        if (m_chart.logX) {
            for (double power = std::floor(m_low.x()); power <= m_high.x(); power += 1.0) {
                for (const double factor : {1.0, 2.0, 5.0}) {
                    const double x = factor * std::pow(10.0, power);
                    if (axis(x) >= m_low.x() && axis(x) <= m_high.x()) {
                        marks.push_back(x);
                    }
                }
            }
            return marks;
        }
        const double step = roundStep(m_high.x() - m_low.x(), 6);
        for (double x = step * std::ceil(m_low.x() / step - 1e-9); x <= m_high.x() + 1e-9 * step; x += step) {
            marks.push_back(std::abs(x) < 1e-12 ? 0.0 : x);
        }
        return marks;
    }

    void paintSeries(QPainter& painter, const ChartSeries& series) {
        painter.setBrush(Qt::NoBrush);
        if (series.line) {
            QPolygonF line;
            for (const ChartSeries::Point& point : series.points) {
                line << at(point.x, point.y);
            }
            painter.setPen(
                QPen(series.colour, 0.14 * m_text, series.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
            painter.drawPolyline(line);
        }
        for (const ChartSeries::Point& point : series.points) {
            const QPointF place = at(point.x, point.y);
            if (!series.line) {
                paintMark(painter, series.mark, series.colour, place, 0.35 * m_text);
            }
            if (!point.label.isEmpty()) {
                painter.setPen(m_palette.text);
                painter.drawText(QRectF(place.x() + 0.55 * m_text, place.y() - 1.5 * m_text, 16.0 * m_text, 1.5 * m_text),
                                 static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), point.label);
            }
        }
        if (!series.name.isEmpty() && !series.points.empty()) {
            const QPointF end = at(series.points.back().x, series.points.back().y);
            painter.setPen(series.colour.darker(115));
            painter.drawText(QRectF(m_plot.right() + 0.4 * m_text, end.y() - 1.6 * m_text, 7.2 * m_text, 3.2 * m_text),
                             static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap), series.name);
        }
    }

    const ReportChart& m_chart;
    double m_text;
    double m_left;  // of the area
    const Palette& m_palette;
    QFont m_font;
    QPointF m_low, m_high;
    QRectF m_plot;
};

}  // namespace

void paintMark(QPainter& painter, ChartMark mark, const QColor& colour, const QPointF& place, double radius) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    if (mark == ChartMark::Dot) {
        painter.drawEllipse(place, radius, radius);
        return;
    }
    const int corners = mark == ChartMark::Triangle ? 3 : 4;
    // A square stands on its side, the others on or below a corner that points up.
    const double first = mark == ChartMark::Square ? 0.25 * M_PI : 0.5 * M_PI;
    QPolygonF outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = first + 2.0 * M_PI * k / corners;
        outline << place + 1.2 * radius * QPointF(std::cos(angle), -std::sin(angle));
    }
    painter.drawPolygon(outline);
}

void ReportChart::paint(QPainter& painter, const QRectF& area, double textHeight) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    ChartSheet(*this, area, textHeight).paint(painter);
    painter.restore();
}

}  // namespace rubble::figures
