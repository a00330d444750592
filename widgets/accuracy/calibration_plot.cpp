#include "widgets/accuracy/calibration_plot.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/analysis/accuracy/published_results.h"
#include "widgets/basics/translated.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr double markReach = 12.0;      // px, of the mouse
constexpr double wideTickSpace = 64.0;  // px, that one tick of an axis takes at least
constexpr int placesOfCurve = 33;
constexpr std::array<PileKind, 2> piles{PileKind::Typical, PileKind::Worst};
constexpr std::array<LiveLoad, 3> loads{LiveLoad::Physics, LiveLoad::Drawing, LiveLoad::Both};

RateCurve curveOf(const Calibration& calibration, PileKind pile, LiveLoad load) {
    RateCurve curve{pile, load, {}};
    double low = 0.0;
    double high = 0.0;
    for (const CalibrationPoint& point : calibration.points) {
        if (point.pile == pile && point.fps(load) > 0.0 && std::isfinite(point.fps(load))) {
            const auto bodies = static_cast<double>(point.bodies);
            low = low > 0.0 ? std::min(low, bodies) : bodies;
            high = std::max(high, bodies);
        }
    }
    for (int i = 0; high > low && i < placesOfCurve; ++i) {
        const double bodies = low * std::pow(high / low, static_cast<double>(i) / (placesOfCurve - 1));
        if (const auto fps = calibration.fps(pile, load, bodies)) {
            curve.places.push_back({bodies, *fps});
        }
    }
    return curve;
}

QString loadWords(LiveLoad load) {
    return load == LiveLoad::Physics ? tr("physics alone") : load == LiveLoad::Drawing ? tr("drawing alone") : tr("both (live)");
}

}  // namespace

CalibrationPlotContent calibrationPlotContent(const Calibration* calibration, double target) {
    CalibrationPlotContent content;
    content.target = target;
    if (calibration != nullptr) {
        for (const PileKind pile : piles) {
            content.bodiesMax[static_cast<std::size_t>(pile)] = calibration->bodiesMax(pile, LiveLoad::Both, target);
            for (const LiveLoad load : loads) {
                content.curves.push_back(curveOf(*calibration, pile, load));
            }
        }
        for (const CalibrationPoint& point : calibration->points) {
            for (const LiveLoad load : loads) {
                if (std::isfinite(point.fps(load)) && point.fps(load) > 0.0) {
                    content.points.push_back({point.pile, load, static_cast<double>(point.bodies), point.fps(load)});
                }
            }
        }
    }
    for (const PublishedRate& rate : publishedRates) {
        content.points.push_back({std::nullopt, LiveLoad::Both, static_cast<double>(rate.bodies), rate.fps});
    }
    return content;
}

QString curveWords(PileKind pile, LiveLoad load) {
    const QString name = pile == PileKind::Typical ? tr("typical pile") : tr("worst pile");
    return QStringLiteral("%1, %2").arg(name, loadWords(load));
}

std::int64_t roundedBodies(const Calibration::BodiesMax& most) {
    const double step = std::max(1.0, std::pow(10.0, std::floor(std::log10(std::max(1.0, most.bodies))) - 1.0));
    return static_cast<std::int64_t>(step * (most.atMost ? std::ceil(most.bodies / step) : std::floor(most.bodies / step)));
}

QString bodiesWords(const Calibration::BodiesMax& most) {
    const QString number = shownCount(roundedBodies(most));
    return most.atLeast ? tr("over %1").arg(number) : most.atMost ? tr("under %1").arg(number) : number;
}

QString ratePointWords(const RatePoint& point) {
    const QString name = point.pile ? curveWords(*point.pile, point.load) : tr("as published, on a GTX 480");
    return tr("%1\n%2 bodies\n%3 FPS").arg(name, shownCount(static_cast<std::int64_t>(point.bodies)), shownNumber(point.fps));
}

CalibrationPlot::CalibrationPlot(const CalibrationPlotContent& content, const QRectF& area, const QFont& font,
                                 const figures::Palette& palette)
    : m_content(content), m_font(font), m_palette(palette) {
    const QFontMetricsF metrics(m_font);
    const double line = metrics.height();
    const double last = 0.5 * metrics.horizontalAdvance(QStringLiteral("100,000"));
    m_field.area = area;
    m_field.frame = area.adjusted(2.0 * line + metrics.horizontalAdvance(QStringLiteral("1,000")), line, -last - 4.0, -3.4 * line);
    settleAxes();
}

void CalibrationPlot::settleAxes() {
    std::pair<double, double> bodies{100.0, 1e5}, fps{0.5, 1000.0};
    if (!m_content.points.empty()) {
        const auto [least, most] = std::ranges::minmax(m_content.points, {}, &RatePoint::bodies);
        const auto [slowest, fastest] = std::ranges::minmax(m_content.points, {}, &RatePoint::fps);
        bodies = {roundOut(least.bodies / 1.15, false), roundOut(most.bodies * 1.15, true)};
        fps = {roundOut(std::min(slowest.fps, m_content.target) / 1.2, false),
               roundOut(std::max(fastest.fps, m_content.target) * 1.2, true)};
    }
    m_field.across = ChartAxis::logarithmicBetween(bodies.first, bodies.second, frame().width() / wideTickSpace);
    m_field.up = ChartAxis::logarithmicBetween(fps.first, fps.second, frame().height() / (0.6 * wideTickSpace));
}

QPointF CalibrationPlot::place(double bodies, double fps) const {
    return m_field.place(bodies, fps);
}

std::optional<std::size_t> CalibrationPlot::pointAt(const QPointF& at) const {
    std::vector<QPointF> places;
    for (const RatePoint& point : m_content.points) {
        places.push_back(place(point.bodies, point.fps));
    }
    return nearestPlace(places, at, markReach);
}

QColor CalibrationPlot::colourOf(LiveLoad load) const {
    return load == LiveLoad::Physics   ? m_palette.categories[1]
           : load == LiveLoad::Drawing ? m_palette.categories[3]
                                       : m_palette.text;
}

void CalibrationPlot::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_font);
    paintAxes(painter);
    for (const RateCurve& curve : m_content.curves) {
        paintCurve(painter, curve);
    }
    std::vector<QRectF> taken;
    for (const RatePoint& point : m_content.points) {
        const QPointF at = place(point.bodies, point.fps);
        taken.emplace_back(at - QPointF(radius, radius), at + QPointF(radius, radius));
    }
    paintTarget(painter, taken);
    for (const RatePoint& point : m_content.points) {
        paintPoint(painter, point);
    }
    paintNames(painter, taken);
}

void CalibrationPlot::paintAxes(QPainter& painter) const {
    const auto bodies = [](double tick) { return shownCount(static_cast<std::int64_t>(tick)); };
    const auto fps = [](double tick) { return QLocale().toString(tick, 'g', 6); };
    m_field.paintAxes(painter, m_font, m_palette, {tr("bodies in the scene"), bodies},
                      {tr("frames per second of wall clock"), fps});
}

void CalibrationPlot::paintCurve(QPainter& painter, const RateCurve& curve) const {
    if (curve.places.size() < 2) {
        return;
    }
    QPolygonF line;
    QPolygonF band;
    for (const RateCurve::Place& at : curve.places) {
        line << place(at.bodies, at.fps.value);
        band << place(at.bodies, at.fps.high);
    }
    painter.save();
    painter.setClipRect(frame());
    const bool typical = curve.pile == PileKind::Typical;
    if (typical && curve.load == LiveLoad::Both) {
        for (auto at = curve.places.rbegin(); at != curve.places.rend(); ++at) {
            band << place(at->bodies, at->fps.low);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_palette.accentTint);
        painter.drawPolygon(band);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colourOf(curve.load), curve.load == LiveLoad::Both ? 2.0 : 1.3, typical ? Qt::SolidLine : Qt::DashLine));
    painter.drawPolyline(line);
    painter.restore();
}

void CalibrationPlot::paintPoint(QPainter& painter, const RatePoint& point) const {
    const QPointF at = place(point.bodies, point.fps);
    if (!point.pile) {
        painter.setPen(QPen(m_palette.fragment, 1.4));
        painter.setBrush(m_palette.fragment);
        painter.drawRect(QRectF(at - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)));
        return;
    }
    const QColor colour = colourOf(point.load);
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(*point.pile == PileKind::Typical ? colour : m_palette.panel);
    painter.drawEllipse(at, radius, radius);
}

void CalibrationPlot::write(QPainter& painter, const QString& words, const QColor& colour, const std::vector<QPointF>& corners,
                            std::vector<QRectF>& taken) const {
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(words) + 4.0, metrics.height());
    for (const QPointF& corner : corners) {
        const QRectF where(corner, size);
        const bool free = frame().contains(where) &&
                          std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(where); });
        if (free) {
            painter.fillRect(where, m_palette.chip);
            painter.setPen(colour);
            painter.drawText(where, Qt::AlignCenter, words);
            taken.push_back(where);
            return;
        }
    }
}

void CalibrationPlot::paintTarget(QPainter& painter, std::vector<QRectF>& taken) const {
    const double line = QFontMetricsF(m_font).height();
    const double y = place(m_field.across.low, m_content.target).y();
    painter.setPen(QPen(m_palette.good, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(frame().left(), y), QPointF(frame().right(), y));
    const QString words = tr("target: %1 FPS").arg(QLocale().toString(m_content.target, 'g', 4));
    const double width = QFontMetricsF(m_font).horizontalAdvance(words) + 10.0;
    write(painter, words, m_palette.good,
          {{frame().left() + 4.0, y - line - 2.0}, {frame().left() + 4.0, y + 2.0}, {frame().right() - width, y - line - 2.0}},
          taken);
    for (const PileKind pile : piles) {
        const auto& most = m_content.bodiesMax[static_cast<std::size_t>(pile)];
        if (!most) {
            continue;
        }
        const double x = std::clamp(place(most->bodies, m_content.target).x(), frame().left(), frame().right());
        painter.setPen(QPen(m_palette.good, 1.3, pile == PileKind::Typical ? Qt::SolidLine : Qt::DotLine));
        painter.drawLine(QPointF(x, y), QPointF(x, frame().bottom()));
        const QString name = pile == PileKind::Typical ? tr("N max, typical: %1") : tr("N max, worst: %1");
        const QString label = name.arg(bodiesWords(*most));
        const double across = QFontMetricsF(m_font).horizontalAdvance(label) + 8.0;
        std::vector<QPointF> corners;
        for (double up = 1.2; up < 8.0; up += 1.2) {
            corners.emplace_back(x + 4.0, frame().bottom() - up * line - 2.0);
            corners.emplace_back(x - across, frame().bottom() - up * line - 2.0);
        }
        write(painter, label, m_palette.good, corners, taken);
    }
}

void CalibrationPlot::paintNames(QPainter& painter, std::vector<QRectF>& taken) const {
    const double line = QFontMetricsF(m_font).height();
    const auto around = [&](const QPointF& at, const QString& words) {
        const double width = QFontMetricsF(m_font).horizontalAdvance(words) + 6.0;
        std::vector<QPointF> corners;
        for (const double below : {0.0, 0.8, 1.6, 2.6, -0.8, -1.6, -2.6}) {
            corners.emplace_back(at.x() + 8.0, at.y() - (0.5 - below) * line);
            corners.emplace_back(at.x() - width - 4.0, at.y() - (0.5 - below) * line);
        }
        return corners;
    };
    // From the top down, and what finds no room gives way downwards: names stand in the order in which the curves end.
    std::vector<const RateCurve*> curves;
    for (const RateCurve& curve : m_content.curves) {
        if (!curve.places.empty()) {
            curves.push_back(&curve);
        }
    }
    std::ranges::stable_sort(curves, std::ranges::greater(), [](const RateCurve* c) { return c->places.back().fps.value; });
    for (const RateCurve* curve : curves) {
        const QString words = curveWords(curve->pile, curve->load);
        const RateCurve::Place& end = curve->places.back();
        write(painter, words, colourOf(curve->load), around(place(end.bodies, end.fps.value), words), taken);
    }
    for (auto point = m_content.points.rbegin(); point != m_content.points.rend() && !point->pile; ++point) {
        const QString words = tr("published (GTX 480)");
        const std::size_t before = taken.size();
        write(painter, words, m_palette.fragment, around(place(point->bodies, point->fps), words), taken);
        if (taken.size() > before) {
            break;
        }
    }
}

}  // namespace rubble::widgets
