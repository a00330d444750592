#include "widgets/views/history_chart.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "widgets/basics/theme.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/round_step.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

constexpr std::size_t fieldCount = 3;
constexpr double tickSpace = 70.0;  // px, that one tick across takes at least

/// A curve of a field.
struct Curve {
    double HistoryPoint::* figure;
    QColor colour;
    QString name;
};

std::vector<Curve> curvesOf(std::size_t field, const figures::Palette& palette) {
    switch (field) {
        case 0:
            return {{&HistoryPoint::topSpeed, palette.structure, HistoryChart::tr("fastest")},
                    {&HistoryPoint::speed, palette.fragment, HistoryChart::tr("in the mean")}};
        case 1:
            return {{&HistoryPoint::height, palette.fragment, HistoryChart::tr("centre of mass")}};
        default:
            return {{&HistoryPoint::potential, palette.structure, HistoryChart::tr("potential")},
                    {&HistoryPoint::kinetic, palette.fragment, HistoryChart::tr("kinetic")}};
    }
}

QString figureOf(std::size_t field, double value, int significant) {
    switch (field) {
        case 0:
            return shownWith(value, "m/s", significant);
        case 1:
            return shownWith(value, "m", significant);
        default:
            return shownEnergy(value, significant);
    }
}

QString nameOf(std::size_t field) {
    const std::array names{HistoryChart::tr("speed"), HistoryChart::tr("height"), HistoryChart::tr("energy")};
    return names[field];
}

ChartAxis axisOver(double low, double high, double count) {
    if (!(high > low)) {
        high = low + std::max(1.0, std::abs(low));
    }
    ChartAxis axis;
    const double step = figures::roundStep(high - low, count);
    axis.low = std::floor(low / step + 1e-9) * step;
    axis.high = std::ceil(high / step - 1e-9) * step;
    for (int i = 0; axis.low + i * step <= axis.high + 1e-6 * step; ++i) {
        axis.ticks.push_back(axis.low + i * step);
    }
    return axis;
}

/// Times are not rounded out: the chart is as long as the timeline.
ChartAxis timeAxis(const HistoryChart::Content& content, double count) {
    const double to = std::max(content.to, content.from + 1e-9);
    ChartAxis axis{content.from, to, false, {}};
    const double step = figures::roundStep(to - content.from, count);
    for (double tick = std::ceil((content.from - content.timeOrigin) / step - 1e-9) * step + content.timeOrigin;
         tick <= to + std::min(1e-9, 1e-6 * step); tick += step) {
        axis.ticks.push_back(tick);
    }
    return axis;
}

void paintCurve(QPainter& painter, const ChartField& field, const std::vector<HistoryPoint>& points, const Curve& curve) {
    QPainterPath path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const QPointF place = field.place(points[i].time, points[i].*curve.figure);
        if (i == 0) {
            path.moveTo(place);
        } else {
            path.lineTo(place);
        }
    }
    painter.setPen(QPen(curve.colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

}  // namespace

HistoryChart::HistoryChart(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("historyChart"));
    setAccessibleName(tr("History curves"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Click or drag to go to an instant"));
}

void HistoryChart::setContent(const Content& content) {
    m_content = content;
    setAccessibleDescription(words());
    update();
}

void HistoryChart::setTime(double time) {
    m_time = time;
    setAccessibleDescription(words());
    update();
}

const HistoryPoint* HistoryChart::pointNow() const {
    const auto after = std::upper_bound(m_content.points.begin(), m_content.points.end(), m_time + 1e-9,
                                        [](double time, const HistoryPoint& point) { return time < point.time; });
    return after == m_content.points.begin() ? nullptr : &*(after - 1);
}

QString HistoryChart::words() const {
    const HistoryPoint* now = pointNow();
    if (now == nullptr) {
        return m_content.points.empty() ? QString() : tr("None of them is on its way yet.");
    }
    const QString instant = figures::timeText(now->time - m_content.timeOrigin);
    const QString first = tr("%1: %2 of fragments, %3 in the mean, %4 the fastest")
                              .arg(instant, shownMass(now->mass), shownWith(now->speed, "m/s"), shownWith(now->topSpeed, "m/s"));
    return tr("%1; at %2; kinetic %3, potential %4")
        .arg(first, shownWith(now->height, "m"), shownEnergy(now->kinetic), shownEnergy(now->potential));
}

std::vector<ChartField> HistoryChart::fieldsIn(const QRectF& area, const QFont& font) const {
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    const double left = 1.8 * line + metrics.horizontalAdvance(QStringLiteral("0,000 MJ")) + 8.0;
    const double below = 2.9 * line;
    const double above = 1.3 * line;
    const double tall = (area.height() - below) / fieldCount;
    std::vector<ChartField> fields;
    for (std::size_t i = 0; i < fieldCount; ++i) {
        ChartField field;
        field.area = QRectF(area.left(), area.top() + static_cast<double>(i) * tall, area.width(), tall);
        field.frame = field.area.adjusted(left, above, -12.0, 0.0);
        field.across = timeAxis(m_content, std::max(2.0, field.frame.width() / tickSpace));
        double low = i == 1 && !m_content.points.empty() ? std::numeric_limits<double>::infinity() : 0.0;
        double high = m_content.points.empty() ? 1.0 : -std::numeric_limits<double>::infinity();
        for (const HistoryPoint& point : m_content.points) {
            for (const Curve& curve : curvesOf(i, tints())) {
                low = std::min(low, point.*curve.figure);
                high = std::max(high, point.*curve.figure);
            }
        }
        field.up = axisOver(low, high, std::max(1.0, field.frame.height() / (2.2 * line)));
        fields.push_back(field);
    }
    return fields;
}

void HistoryChart::paintChart(QPainter& painter, const QRectF& area, const QFont& font, const figures::Palette& palette) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const std::vector<ChartField> fields = fieldsIn(area, font);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const ChartField& field = fields[i];
        const bool last = i + 1 == fields.size();
        const figures::ShownUnit unit = figures::timeUnit(m_content.to - m_content.from);
        const AxisWords across{last ? tr("time, %1").arg(unit.name) : QString(), [&](double tick) {
                                   const double told = (tick - m_content.timeOrigin) * unit.perSi;
                                   return last ? QLocale().toString(std::round(1e9 * told) / 1e9, 'g', 6) : QString();
                               }};
        const std::vector<double>& ticks = field.up.ticks;
        const double apart = ticks.size() > 1 ? ticks[1] - ticks[0] : 0.0;
        field.paintAxes(
            painter, font, palette, across,
            {nameOf(i), [i, apart](double tick) { return figureOf(i, tick, std::max(3, figures::digitsOfMark(tick, apart))); }});
        double right = field.frame.right();
        for (const Curve& curve : curvesOf(i, palette)) {
            paintCurve(painter, field, m_content.points, curve);
        }
        const std::vector<Curve> curves = curvesOf(i, palette);
        for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) {
            const double wide = metrics.horizontalAdvance(curve->name) + 14.0;
            painter.setPen(palette.muted);
            painter.drawText(QRectF(right - wide, field.area.top(), wide, 1.2 * metrics.height()),
                             Qt::AlignRight | Qt::AlignVCenter, curve->name);
            painter.setPen(QPen(curve->colour, 2.0));
            const double middle = field.area.top() + 0.6 * metrics.height();
            painter.drawLine(QPointF(right - wide, middle), QPointF(right - wide + 10.0, middle));
            right -= wide + 10.0;
        }
    }
}

void HistoryChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF area(rect());
    paintChart(painter, area, headingFont(), tints());
    const std::vector<ChartField> fields = fieldsIn(area, headingFont());
    const double x = placeOf(m_time);
    if (x >= fields.front().frame.left() - 0.5 && x <= fields.front().frame.right() + 0.5) {
        // Crisp, whatever the share of a pixel at which it stands.
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(tints().accent, 2.0));
        painter.drawLine(QPointF(x, fields.front().frame.top()), QPointF(x, fields.back().frame.bottom()));
    }
}

void HistoryChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    paintChart(painter, area, font, figures::palette(render::Theme::Print));
}

QString HistoryChart::fileTitle() const {
    return tr("History of %1").arg(m_content.subject);
}

double HistoryChart::placeOf(double time) const {
    return fieldsIn(QRectF(rect()), headingFont()).front().place(time, 0.0).x();
}

double HistoryChart::timeAt(double x) const {
    const ChartField field = fieldsIn(QRectF(rect()), headingFont()).front();
    const double share = std::clamp((x - field.frame.left()) / std::max(1.0, field.frame.width()), 0.0, 1.0);
    return field.across.low + share * (field.across.high - field.across.low);
}

void HistoryChart::ask(const QPointF& place) {
    if (!m_content.points.empty()) {
        emit timeRequested(timeAt(place.x()));
    }
}

void HistoryChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        ask(event->position());
    }
}

void HistoryChart::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) {
        ask(event->position());
    }
}

bool HistoryChart::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        setContent(m_content);
    }
    return QWidget::event(event);
}

}  // namespace rubble::widgets
