#include "widgets/basics/chart_axis.h"

#include <QFontMetricsF>
#include <QPainter>
#include <array>
#include <cmath>

namespace rubble::widgets {

std::vector<double> logTicks(double low, double high, double room) {
    std::vector<double> ticks;
    for (const auto& steps : {std::vector<double>{1.0, 2.0, 5.0}, std::vector<double>{1.0, 3.0}, std::vector<double>{1.0}}) {
        ticks.clear();
        for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, power) <= high; ++power) {
            for (const double step : steps) {
                const double tick = step * std::pow(10.0, power);
                if (tick >= low * (1.0 - 1e-9) && tick <= high * (1.0 + 1e-9)) {
                    ticks.push_back(tick);
                }
            }
        }
        if (static_cast<double>(ticks.size()) <= room) {
            break;
        }
    }
    return ticks;
}

double roundOut(double value, bool up) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const std::array<double, 6> steps{1.0, 2.0, 3.0, 5.0, 10.0, 20.0};
    double found = steps[0];
    for (const double step : steps) {
        if (up && step * power >= value * (1.0 - 1e-9)) {
            return step * power;
        }
        if (!up && step * power <= value * (1.0 + 1e-9)) {
            found = step;
        }
    }
    return found * power;
}

ChartAxis ChartAxis::logarithmicBetween(double low, double high, double room) {
    return {low, high, true, logTicks(low, high, room)};
}

double ChartAxis::share(double value) const {
    return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

QPointF ChartField::place(double x, double y) const {
    return {frame.left() + across.share(x) * frame.width(), frame.bottom() - up.share(y) * frame.height()};
}

void ChartField::paintAxes(QPainter& painter, const QFont& font, const figures::Palette& palette, const AxisWords& acrossWords,
                           const AxisWords& upWords) const {
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    for (const double tick : across.ticks) {
        const double x = place(tick, up.low).x();
        painter.setPen(QPen(palette.hairline, 1.0));
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
        painter.setPen(palette.muted);
        painter.drawText(QRectF(x - 40.0, frame.bottom() + 4.0, 80.0, line), Qt::AlignHCenter | Qt::AlignTop,
                         acrossWords.figure(tick));
    }
    for (const double tick : up.ticks) {
        const double y = place(across.low, tick).y();
        painter.setPen(QPen(palette.hairline, 1.0));
        painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
        painter.setPen(palette.muted);
        painter.drawText(QRectF(area.left(), y - line, frame.left() - area.left() - 6.0, 2.0 * line),
                         Qt::AlignRight | Qt::AlignVCenter, upWords.figure(tick));
    }
    painter.setPen(palette.muted);
    painter.drawText(QRectF(area.left(), frame.bottom() + 1.7 * line, area.width(), line), Qt::AlignCenter, acrossWords.title);
    painter.save();
    painter.translate(area.left() + 0.8 * line, frame.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * area.height(), -0.6 * line, area.height(), 1.2 * line), Qt::AlignCenter,
                     metrics.elidedText(upWords.title, Qt::ElideRight, area.height()));
    painter.restore();
}

std::optional<std::size_t> nearestPlace(std::span<const QPointF> places, const QPointF& at, double reach) {
    std::optional<std::size_t> found;
    double nearest = reach;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const QPointF apart = places[i] - at;
        const double distance = std::hypot(apart.x(), apart.y());
        if (distance <= nearest) {
            nearest = distance;
            found = i;
        }
    }
    return found;
}

}  // namespace rubble::widgets
