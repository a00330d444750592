// The scale of the timeline: places of times, and the axis.
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/round_step.h"
#include "widgets/views/timeline.h"

namespace rubble::widgets {

// A blast of microseconds is no single pixel of the seconds that its debris takes to come to rest.
std::optional<double> Timeline::fold() const {
    const double fe = m_feEnd - m_first;
    return fe > 0.0 && fe < leastShare * (m_last - m_first) ? std::optional(m_feEnd) : std::nullopt;
}

double Timeline::toX(double time) const {
    const Rows r = rows();
    if (m_last <= m_first) {
        return r.left;
    }
    const double wide = r.right - r.left;
    if (const auto folded = fold()) {
        const double half = 0.5 * wide;
        return time <= *folded ? r.left + half * (time - m_first) / (*folded - m_first)
                               : r.left + half + half * (time - *folded) / (m_last - *folded);
    }
    return r.left + (time - m_first) / (m_last - m_first) * wide;
}

double Timeline::toTime(double x) const {
    const Rows r = rows();
    const double share = std::clamp((x - r.left) / std::max(1.0, r.right - r.left), 0.0, 1.0);
    if (const auto folded = fold()) {
        return share <= 0.5 ? m_first + 2.0 * share * (*folded - m_first) : *folded + (2.0 * share - 1.0) * (m_last - *folded);
    }
    return m_first + share * (m_last - m_first);
}

void Timeline::paintAxis(QPainter& painter, const Rows& r) const {
    painter.setPen(tints().hairline);
    painter.drawLine(QPointF(r.left, r.axis), QPointF(r.right, r.axis));
    const auto folded = fold();
    paintTicks(painter, r, m_first, folded.value_or(m_last));
    if (folded) {
        paintTicks(painter, r, *folded, m_last);
    }
}

void Timeline::paintTicks(QPainter& painter, const Rows& r, double first, double last) const {
    const figures::ShownUnit told = figures::timeUnit(last - first);
    const double unit = 1.0 / told.perSi;
    const double step = figures::roundStep((last - first) / unit, (toX(last) - toX(first)) / 56.0);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    painter.setPen(tints().muted);
    const double start = std::ceil((first - m_origin) / unit / step - 1e-9);
    // Beyond a fold the zero of the second scale stands where the first one ends.
    const double begin = first > m_first ? std::max(start, std::floor((first - m_origin) / unit / step) + 1.0) : start;
    for (double k = begin; k * step * unit + m_origin <= last * (1.0 + 1e-12) + 1e-12; k += 1.0) {
        const double x = toX(k * step * unit + m_origin);
        painter.drawLine(QPointF(x, r.axis), QPointF(x, r.axis + 3));
        QString label = QLocale().toString(k * step, 'f', decimals);
        if (k == begin) {
            label += u' ' + told.name;
        }
        const double half = painter.fontMetrics().horizontalAdvance(label) / 2.0;
        painter.drawText(QPointF(x - half, r.axis + 5 + painter.fontMetrics().ascent()), label);
    }
}

}  // namespace rubble::widgets
