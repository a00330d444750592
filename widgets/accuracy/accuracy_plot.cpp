#include "widgets/accuracy/accuracy_plot.h"

#include <QCoreApplication>
#include <QLineF>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "core/base/unknown.h"
#include "widgets/accuracy/accuracy_words.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/round_step.h"

namespace rubble::widgets {

namespace {

constexpr double reach = 14.0;      // px, of the mouse
constexpr double tickSpace = 56.0;  // px, that one tick of an axis takes at least

/// Whether a line of pieces goes through a rectangle.
bool crosses(const QPolygonF& line, const QRectF& area) {
    const std::array<QPointF, 5> around{area.topLeft(), area.topRight(), area.bottomRight(), area.bottomLeft(), area.topLeft()};
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QLineF piece(line[i], line[i + 1]);
        for (std::size_t k = 0; k + 1 < around.size(); ++k) {
            if (piece.intersects(QLineF(around[k], around[k + 1])) == QLineF::BoundedIntersection) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

PlotContent plotContent(const AccuracyReport& report, CostKind cost, const AccuracyKind& accuracy, std::optional<int> inUse,
                        double fpsTarget) {
    PlotContent content;
    content.cost = cost;
    content.accuracy = accuracy;
    content.band = floorBand(report, accuracy);
    content.fpsTarget = fpsTarget;
    const auto add = [&](const AccuracyPoint& point, int row) {
        PlotPoint shown;
        shown.row = row;
        shown.name = settingWords(point.setting);
        shown.words = pointWords(point);
        shown.at = {costOf(point, cost), point.done ? accuracyOf(point.difference, accuracy) : unknown};
        shown.range = accuracyRange(point, accuracy);
        shown.published = row != referenceRow && point.setting == paperSetting;
        shown.inUse = inUse == row;
        if (point.done && std::isfinite(shown.at.cost) && shown.at.cost > 0.0 && std::isfinite(shown.at.accuracy)) {
            content.points.push_back(std::move(shown));
        } else {
            ++content.left;
        }
    };
    add(report.reference, referenceRow);
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        add(report.points[i], static_cast<int>(i));
    }
    std::stable_sort(content.points.begin(), content.points.end(),
                     [](const PlotPoint& a, const PlotPoint& b) { return a.at.cost < b.at.cost; });
    // The reference agrees with itself, which is no merit: it is on no front.
    std::vector<CostAccuracy> places;
    for (const PlotPoint& point : content.points) {
        places.push_back(point.at);
        if (point.row == referenceRow) {
            places.back().accuracy = std::numeric_limits<double>::quiet_NaN();
        }
    }
    for (const std::size_t i : paretoFront(places, cost == CostKind::Fps, accuracy.moreIsBetter())) {
        content.points[i].front = true;
    }
    content.target = costAtRate(report, cost, fpsTarget);
    return content;
}

AccuracyPlot::AccuracyPlot(const PlotContent& content, const QRectF& area, const QFont& font, const figures::Palette& palette)
    : m_content(content), m_font(font), m_palette(palette) {
    const QFontMetricsF metrics(m_font);
    const double line = metrics.height();
    m_field.area = area;
    m_field.frame =
        area.adjusted(2.0 * line + metrics.horizontalAdvance(QStringLiteral("0.000")), 1.2 * line, -1.5 * line, -3.4 * line);
    m_field.across = costAxis();
    m_field.up = accuracyAxis();
}

ChartAxis AccuracyPlot::costAxis() const {
    double low = m_content.points.empty() ? 1.0 : m_content.points.front().at.cost;
    double high = m_content.points.empty() ? 100.0 : m_content.points.back().at.cost;
    if (m_content.target && *m_content.target > 0.0) {
        low = std::min(low, *m_content.target);
        high = std::max(high, *m_content.target);
    }
    return ChartAxis::logarithmicBetween(roundOut(low / 1.15, false), roundOut(high * 1.15, true), frame().width() / tickSpace);
}

ChartAxis AccuracyPlot::accuracyAxis() const {
    ChartAxis axis;
    const bool more = m_content.accuracy.moreIsBetter();
    double low = more ? 1.0 : 0.0;
    double high = low;
    const auto hold = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const PlotPoint& point : m_content.points) {
        hold(point.at.accuracy);
        if (point.range) {
            hold(point.range->first);
            hold(point.range->second);
        }
    }
    if (m_content.band) {
        hold(m_content.band->first);
        hold(m_content.band->second);
    }
    const double least = more ? 0.1 : 0.01;
    const double span = std::max(high - low, least);
    const double step = figures::roundStep(span * 1.1, std::max(2.0, frame().height() / tickSpace));
    axis.low = more ? std::max(0.0, std::floor((1.0 - 1.05 * span) / step + 1e-9) * step) : 0.0;
    axis.high = more ? 1.0 : std::ceil(1.05 * span / step - 1e-9) * step;
    for (double tick = axis.low; tick <= axis.high + 0.01 * step; tick += step) {
        axis.ticks.push_back(tick);
    }
    return axis;
}

QPointF AccuracyPlot::place(const CostAccuracy& at) const {
    return m_field.place(at.cost, at.accuracy);
}

std::optional<std::size_t> AccuracyPlot::pointAt(const QPointF& at) const {
    std::vector<QPointF> places;
    for (const PlotPoint& point : m_content.points) {
        places.push_back(place(point.at));
    }
    return nearestPlace(places, at, reach);
}

void AccuracyPlot::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_font);
    paintBand(painter);
    paintAxes(painter);
    std::vector<QRectF> taken;
    paintTarget(painter, taken);
    paintFront(painter);
    for (const PlotPoint& point : m_content.points) {
        paintSpread(painter, point, taken);
    }
    for (const PlotPoint& point : m_content.points) {
        paintPoint(painter, point);
        const QPointF at = place(point.at);
        taken.emplace_back(at - QPointF(radius, radius), at + QPointF(radius, radius));
    }
    paintNames(painter, taken);
}

void AccuracyPlot::paintAxes(QPainter& painter) const {
    const double unit = m_content.accuracy.tolerance ? 100.0 : 1.0;
    const auto cost = [](double tick) { return QLocale().toString(tick, 'g', 6); };
    const std::vector<double>& ticks = m_field.up.ticks;
    const double apart = ticks.size() > 1 ? ticks[1] - ticks[0] : 0.0;
    const auto accuracy = [unit, apart](double tick) {
        return QLocale().toString(std::round(unit * tick * 1e6) / 1e6, 'g', std::max(4, figures::digitsOfMark(tick, apart)));
    };
    m_field.paintAxes(painter, m_font, m_palette, {costAxisWords(m_content.cost), cost},
                      {accuracyAxisWords(m_content.accuracy), accuracy});
}

void AccuracyPlot::paintBand(QPainter& painter) const {
    if (!m_content.band) {
        return;
    }
    const double top = std::max(frame().top(), place({m_field.across.low, m_content.band->second}).y());
    const double bottom = std::min(frame().bottom(), place({m_field.across.low, m_content.band->first}).y());
    const QRectF band(QPointF(frame().left(), top), QPointF(frame().right(), std::max(bottom, top + 1.0)));
    painter.fillRect(band, m_palette.accentTint);
    // Hatched and named, so that the band is not told by its colour alone.
    painter.fillRect(band, QBrush(m_palette.hairline, Qt::BDiagPattern));
}

void AccuracyPlot::paintTarget(QPainter& painter, std::vector<QRectF>& taken) const {
    const QFontMetricsF metrics(m_font);
    const auto write = [&](QRectF at, const QString& words, const QColor& colour) {
        painter.setPen(colour);
        painter.fillRect(at.adjusted(-2.0, 0.0, 2.0, 0.0), m_palette.chip);
        painter.drawText(at, Qt::AlignCenter, words);
        taken.push_back(at);
    };
    if (const QPolygonF line = targetLine(); !line.isEmpty()) {
        const double x = line.front().x();
        painter.setPen(QPen(m_palette.good, 1.5, Qt::DashLine));
        painter.drawPolyline(line);
        const QString words = tr("%1 FPS on this machine").arg(QLocale().toString(m_content.fpsTarget, 'g', 4));
        const QSizeF size(metrics.horizontalAdvance(words) + 2.0, metrics.height());
        const bool right = x + 8.0 + size.width() < frame().right();
        write({QPointF(right ? x + 6.0 : x - 6.0 - size.width(), frame().bottom() - size.height() - 4.0), size}, words,
              m_palette.good);
    }
    if (m_content.band) {
        const QString words = tr("repeat floor of the reference");
        const QSizeF size(metrics.horizontalAdvance(words) + 2.0, metrics.height());
        const bool up = m_content.accuracy.moreIsBetter();
        const double edge = place({m_field.across.low, up ? m_content.band->first : m_content.band->second}).y();
        const double inside = up ? edge - size.height() - 3.0 : edge + 3.0;
        const double outside = up ? edge + 3.0 : edge - size.height() - 3.0;
        const double right = frame().right() - size.width() - 6.0;
        // Where neither points nor lines lie, then where at least no point does; the first place if points lie everywhere.
        const double far = up ? place({m_field.across.low, m_content.band->second}).y() + 3.0
                              : place({m_field.across.low, m_content.band->first}).y() - size.height() - 3.0;
        std::vector<QRectF> places;
        for (const double y : {inside, outside, far}) {
            for (const double share : {0.0, 1.0, 0.5, 0.25, 0.75}) {
                const double x = frame().left() + 6.0 + share * (right - frame().left() - 6.0);
                places.emplace_back(QPointF(x, std::clamp(y, frame().top() + 2.0, frame().bottom() - size.height() - 2.0)), size);
            }
        }
        const auto aroundOf = [](const QRectF& where) {
            return where.adjusted(-2.0 * radius, -2.0 * radius, 2.0 * radius, 2.0 * radius);
        };
        const auto offPoints = [&](const QRectF& where) {
            const auto holds = [&](const PlotPoint& point) { return aroundOf(where).contains(place(point.at)); };
            const auto meets = [&](const QRectF& other) { return other.intersects(where); };
            return std::ranges::none_of(m_content.points, holds) && std::ranges::none_of(taken, meets);
        };
        const auto offLines = [&](const QRectF& where) {
            return !crosses(targetLine(), aroundOf(where)) && !crosses(frontLine(), where);
        };
        auto free = std::ranges::find_if(places, [&](const QRectF& where) { return offPoints(where) && offLines(where); });
        if (free == places.end()) {
            free = std::ranges::find_if(places, offPoints);
        }
        write(free != places.end() ? *free : places.front(), words, m_palette.accent);
    }
}

/// Where the cost reaches the target for FPS; empty: that is not known.
QPolygonF AccuracyPlot::targetLine() const {
    if (!m_content.target) {
        return {};
    }
    const double x = place({*m_content.target, m_field.up.low}).x();
    return {{x, frame().top()}, {x, frame().bottom()}};
}

QPolygonF AccuracyPlot::frontLine() const {
    QPolygonF front;
    for (const PlotPoint& point : m_content.points) {
        if (point.front) {
            front << place(point.at);
        }
    }
    return front;
}

void AccuracyPlot::paintFront(QPainter& painter) const {
    painter.setPen(QPen(m_palette.muted, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(frontLine());
}

void AccuracyPlot::paintSpread(QPainter& painter, const PlotPoint& point, std::vector<QRectF>& taken) const {
    if (!point.range) {
        return;
    }
    const QPointF low = place({point.at.cost, point.range->first}), high = place({point.at.cost, point.range->second});
    const QPointF cap(0.6 * radius, 0.0);
    painter.setPen(QPen(point.published ? m_palette.fragment : m_palette.muted, 1.2));
    painter.drawLine(low, high);
    painter.drawLine(low - cap, low + cap);
    painter.drawLine(high - cap, high + cap);
    taken.push_back(QRectF(low - cap, high + cap).normalized());
}

void AccuracyPlot::paintPoint(QPainter& painter, const PlotPoint& point) const {
    const QPointF at = place(point.at);
    const bool reference = point.row == referenceRow;
    const QColor colour = point.published ? m_palette.fragment : reference ? m_palette.text : m_palette.accent;
    painter.setPen(QPen(point.front || point.published || reference ? colour : m_palette.muted, 1.6));
    painter.setBrush(point.front ? colour : m_palette.panel);
    if (point.published) {
        painter.setBrush(m_palette.fragment);
        painter.drawRect(QRectF(at - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)).adjusted(0.5, 0.5, -0.5, -0.5));
    } else if (reference) {
        painter.drawPolygon(QPolygonF(
            {at - QPointF(0, radius + 1), at + QPointF(radius + 1, 0), at + QPointF(0, radius + 1), at - QPointF(radius + 1, 0)}));
    } else {
        painter.drawEllipse(at, radius, radius);
    }
    if (point.inUse) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_palette.accent, 1.8));
        painter.drawEllipse(at, radius + 4.5, radius + 4.5);
    }
}

void AccuracyPlot::paintNames(QPainter& painter, std::vector<QRectF>& taken) const {
    // What is marked is named first; other names only where they fit.
    std::vector<const PlotPoint*> order;
    for (const PlotPoint& point : m_content.points) {
        order.push_back(&point);
    }
    const auto rank = [](const PlotPoint* p) {
        return p->inUse ? 0 : p->published ? 1 : p->row == referenceRow ? 2 : p->front ? 3 : 4;
    };
    std::stable_sort(order.begin(), order.end(), [&](const PlotPoint* a, const PlotPoint* b) { return rank(a) < rank(b); });
    const QPolygonF front = frontLine(), target = targetLine();
    for (const PlotPoint* point : order) {
        QFont font = m_font;
        font.setBold(point->inUse);
        const QFontMetricsF metrics(font);
        const QPointF at = place(point->at);
        // Where the whole name finds no room the mark is named at least.
        QStringList names{point->inUse ? tr("%1 (in use)").arg(point->name) : point->name};
        if (point->inUse) {
            names << tr("in use");
        }
        for (const QString& name : std::as_const(names)) {
            const QSizeF size(metrics.horizontalAdvance(name) + 2.0, metrics.height());
            const double gap = radius + (point->inUse ? 8.0 : 4.0);
            const double left = at.x() - gap - size.width(), right = at.x() + gap, middle = at.x() - 0.5 * size.width();
            const double above = at.y() - gap - size.height(), beside = at.y() - 0.5 * size.height(), below = at.y() + gap;
            std::vector<QRectF> places;
            for (const QPointF& corner :
                 {QPointF(right, beside), QPointF(middle, above), QPointF(middle, below), QPointF(left, beside),
                  QPointF(right, at.y() + 2.0), QPointF(left, at.y() + 2.0), QPointF(left, above)}) {
                const QRectF where(corner, size);
                if (frame().contains(where) &&
                    std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(where); })) {
                    places.push_back(where);
                }
            }
            auto chosen = std::find_if(places.begin(), places.end(),
                                       [&](const QRectF& where) { return !crosses(front, where) && !crosses(target, where); });
            // On a line rather than nowhere, if it is marked.
            if (chosen == places.end() && rank(point) < 3 && name == names.back()) {
                chosen = places.begin();
            }
            if (chosen != places.end()) {
                painter.setFont(font);
                painter.setPen(point->published ? m_palette.fragment : point->inUse ? m_palette.text : m_palette.muted);
                painter.drawText(*chosen, Qt::AlignCenter, name);
                taken.push_back(*chosen);
                break;
            }
        }
    }
    painter.setFont(m_font);
}

}  // namespace rubble::widgets
