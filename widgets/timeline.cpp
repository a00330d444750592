#include "widgets/timeline.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/theme.h"
#include "widgets/wording.h"

namespace rubble::widgets {

double roundStep(double span, double count) {
    if (!(span > 0.0) || !(count > 0.0)) {
        return 1.0;
    }
    const double least = span / count;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-12)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

/// Where things stand, from top to bottom.
struct Timeline::Rows {
    double left, right;
    double deathsTop, deathsBottom;
    double barTop, barBottom;
    double axis;
};

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(tr("Timeline"));
    setToolTip(tr("Deaths over time and what is computed. Drag to scrub."));
}

Timeline::Rows Timeline::rows() const {
    const double label = fontMetrics().horizontalAdvance(tr("computed")) + 24.0;
    const double axis = height() - fontMetrics().height() - 10.0;
    return {label, width() - 24.0, 12.0, axis - 24.0, axis - 16.0, axis - 8.0, axis};
}

void Timeline::setRange(double first, double last) {
    m_first = first;
    m_last = std::max(first, last);
    update();
}

void Timeline::setDeaths(std::vector<double> times, std::vector<double> deaths) {
    m_times = std::move(times);
    m_deaths = std::move(deaths);
    update();
}

void Timeline::setFeEnd(double time) {
    m_feEnd = time;
    update();
}

void Timeline::setComputed(double first, double last, bool stale) {
    m_computedFirst = first;
    m_computedLast = last;
    m_stale = stale;
    update();
}

void Timeline::setTime(double time) {
    m_time = time;
    update();
}

double Timeline::toX(double time) const {
    const Rows r = rows();
    return m_last > m_first ? r.left + (time - m_first) / (m_last - m_first) * (r.right - r.left) : r.left;
}

double Timeline::toTime(double x) const {
    const Rows r = rows();
    const double share = std::clamp((x - r.left) / std::max(1.0, r.right - r.left), 0.0, 1.0);
    return m_first + share * (m_last - m_first);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_last > m_first) {
        emit scrubbed(toTime(event->position().x()));
    }
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0 && m_last > m_first) {
        emit scrubbed(toTime(event->position().x()));
    }
}

void Timeline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(headingFont());
    const Rows r = rows();
    painter.setPen(tints().muted);
    if (m_last <= m_first) {
        painter.drawText(rect(), Qt::AlignCenter, tr("The timeline appears when a result is open."));
        return;
    }
    painter.drawText(QPointF(12, r.deathsTop + painter.fontMetrics().ascent()), tr("deaths"));
    painter.drawText(QPointF(12, r.barBottom), tr("computed"));
    paintDeaths(painter, r);
    paintComputed(painter, r);
    paintAxis(painter, r);
    paintMarks(painter, r);
}

void Timeline::paintDeaths(QPainter& painter, const Rows& r) const {
    const double most = m_deaths.empty() ? 0.0 : *std::max_element(m_deaths.begin(), m_deaths.end());
    if (most <= 0.0) {
        painter.drawText(QPointF(r.left, r.deathsBottom - 4), tr("no element dies in this result"));
        return;
    }
    QPainterPath outline(QPointF(toX(m_times.front()), r.deathsBottom));
    for (std::size_t i = 0; i < m_times.size(); ++i) {
        outline.lineTo(toX(m_times[i]), r.deathsBottom - (r.deathsBottom - r.deathsTop) * m_deaths[i] / most);
    }
    QPainterPath area = outline;
    area.lineTo(toX(m_times.back()), r.deathsBottom);
    area.closeSubpath();
    QColor wash = tints().fragment;
    wash.setAlphaF(0.25F);
    painter.fillPath(area, wash);
    painter.setPen(QPen(tints().fragment, 1.3));
    painter.drawPath(outline);
    // The peak is labelled directly, with its place.
    const auto peak = static_cast<std::size_t>(std::max_element(m_deaths.begin(), m_deaths.end()) - m_deaths.begin());
    painter.setPen(tints().muted);
    const QString label = tr("%1 in one state").arg(shownCount(static_cast<std::int64_t>(most)));
    const double width = painter.fontMetrics().horizontalAdvance(label);
    double x = toX(m_times[peak]) + 8.0;
    if (x + width > r.right) {
        x = toX(m_times[peak]) - 8.0 - width;
    }
    painter.drawText(QPointF(x, r.deathsTop + painter.fontMetrics().ascent() - 2.0), label);
}

void Timeline::paintComputed(QPainter& painter, const Rows& r) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(tints().hairline);
    painter.drawRoundedRect(QRectF(QPointF(r.left, r.barTop), QPointF(r.right, r.barBottom)), 3, 3);
    if (m_computedLast > m_computedFirst) {
        QColor colour = tints().accent;
        colour.setAlphaF(m_stale ? 0.45F : 1.0F);
        painter.setBrush(m_stale ? QBrush(colour, Qt::BDiagPattern) : QBrush(colour));
        painter.drawRoundedRect(QRectF(QPointF(toX(m_computedFirst), r.barTop), QPointF(toX(m_computedLast), r.barBottom)), 3, 3);
    }
    painter.setBrush(Qt::NoBrush);
}

void Timeline::paintAxis(QPainter& painter, const Rows& r) const {
    painter.setPen(tints().hairline);
    painter.drawLine(QPointF(r.left, r.axis), QPointF(r.right, r.axis));
    const double step = roundStep(m_last - m_first, (r.right - r.left) / 56.0);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    painter.setPen(tints().muted);
    const double start = std::ceil(m_first / step - 1e-9);
    for (double k = start; k * step <= m_last * (1.0 + 1e-12); k += 1.0) {
        const double x = toX(k * step);
        painter.drawLine(QPointF(x, r.axis), QPointF(x, r.axis + 3));
        QString label = QLocale().toString(k * step, 'f', decimals);
        if (k == start) {
            label += QStringLiteral(" s");
        }
        const double half = painter.fontMetrics().horizontalAdvance(label) / 2.0;
        painter.drawText(QPointF(x - half, r.axis + 5 + painter.fontMetrics().ascent()), label);
    }
}

void Timeline::paintMarks(QPainter& painter, const Rows& r) const {
    if (m_feEnd > m_first && m_feEnd < m_last) {
        painter.setPen(QPen(tints().muted, 1, Qt::DashLine));
        const double x = toX(m_feEnd);
        painter.drawLine(QPointF(x, r.deathsTop - 6), QPointF(x, r.axis));
        painter.drawText(QPointF(x + 5, r.deathsTop + painter.fontMetrics().ascent() - 2), tr("FE ends"));
    }
    const double x = toX(m_time);
    painter.setPen(QPen(tints().text, 1.6));
    painter.drawLine(QPointF(x, 6), QPointF(x, r.axis));
    painter.setBrush(tints().text);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(x, 6), 4, 4);
    painter.setBrush(Qt::NoBrush);
}

}  // namespace rubble::widgets
