#include "widgets/figures/marks.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"
#include "widgets/figures/translated.h"
#include "widgets/render/basics/camera.h"

namespace rubble::figures {
namespace {

/// Metrics and colours of the marks of one pane.
struct Pen {
    const render::View& view;
    const render::Pane& pane;
    const Palette& colours;
    QFont font;
    double unit;  ///< 4 px of a 13 px font
};

double unitOf(double textHeight) {
    return 4.0 * textHeight / 13.0;
}

std::optional<QPointF> pixelOf(const render::View& view, const render::Pane& pane, const Vec3& point) {
    const auto place = render::project(render::cameraOf(view, pane.content), point, pane.aspect());
    if (!place) {
        return std::nullopt;
    }
    return QPointF(pane.x + place->u * pane.width, pane.y + place->v * pane.height);
}

std::optional<QPointF> pixelOf(const Pen& pen, const Vec3& point) {
    return pixelOf(pen.view, pen.pane, point);
}

/// A line that is seen on any background.
void stroke(QPainter& painter, const Pen& pen, const QPainterPath& line, const QColor& colour) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(pen.colours.chip, 1.1 * pen.unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
    painter.setPen(QPen(colour, 0.5 * pen.unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
}

void label(QPainter& painter, const Pen& pen, const QPointF& middle, const QString& text) {
    const QFontMetricsF metrics(pen.font);
    const QSizeF size(metrics.horizontalAdvance(text) + 3.0 * pen.unit, metrics.height() + pen.unit);
    const QRectF box(middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
    painter.setPen(QPen(pen.colours.accent, 0.25 * pen.unit));
    painter.setBrush(pen.colours.chip);
    painter.drawRoundedRect(box, 0.75 * pen.unit, 0.75 * pen.unit);
    painter.setPen(pen.colours.chipText);
    painter.drawText(box, Qt::AlignCenter | Qt::TextSingleLine, text);
}

void paintMeasurement(QPainter& painter, const Pen& pen, const render::Measurement& measured) {
    // A height is measured along the plumb line below or above its first end.
    const Vec3 corner(measured.from.x(), measured.from.y(), measured.to.z());
    const auto from = pixelOf(pen, measured.from);
    const auto to = pixelOf(pen, measured.to);
    const auto foot = pixelOf(pen, measured.height ? corner : measured.to);
    if (!from || !to || !foot) {
        return;
    }
    if (measured.height) {
        painter.setPen(QPen(pen.colours.accent, 0.25 * pen.unit, Qt::DashLine));
        painter.drawLine(*foot, *to);
    }
    QPainterPath line(*from);
    line.lineTo(*foot);
    stroke(painter, pen, line, pen.colours.accent);
    for (const QPointF& end : {*from, *to}) {
        painter.setPen(QPen(pen.colours.accent, 0.5 * pen.unit));
        painter.setBrush(pen.colours.chip);
        painter.drawEllipse(end, pen.unit, pen.unit);
    }
    const QString text = measured.height ? QCoreApplication::translate("figures", "%1 high").arg(measuredText(measured.length()))
                                         : measuredText(measured.length());
    const double shift = QFontMetricsF(pen.font).height() + pen.unit;
    label(painter, pen, 0.5 * (*from + *foot) - QPointF(0.0, shift), text);
}

/// From a ring at the birth to a disc where the fragment ends.
void paintPath(QPainter& painter, const Pen& pen) {
    QPainterPath line;
    std::optional<QPointF> before, first, last;
    for (const Vec3& point : pen.view.path) {
        const auto pixel = pixelOf(pen, point);
        if (pixel && before) {
            line.lineTo(*pixel);
        } else if (pixel) {
            line.moveTo(*pixel);
        }
        before = pixel;
        if (!first) {
            first = pixel;
        }
        if (pixel) {
            last = pixel;
        }
    }
    if (!first) {
        return;
    }
    stroke(painter, pen, line, pen.colours.accent);
    painter.setPen(QPen(pen.colours.accent, 0.5 * pen.unit));
    painter.setBrush(pen.colours.chip);
    painter.drawEllipse(*first, 1.25 * pen.unit, 1.25 * pen.unit);
    painter.setBrush(pen.colours.accent);
    painter.drawEllipse(*last, 1.0 * pen.unit, 1.0 * pen.unit);
}

constexpr double axesSide = 21.0;    // units, of the square in a corner that they take
constexpr double axesMiddle = 11.0;  // units, from the corner to where they meet

QRectF axesSquare(const render::Pane& pane, double unit, Corner corner) {
    const double side = axesSide * unit;
    const bool right = corner == Corner::UpperRight || corner == Corner::LowerRight;
    const bool upper = corner == Corner::UpperRight || corner == Corner::UpperLeft;
    return {right ? pane.x + pane.width - side : pane.x, upper ? pane.y : pane.y + pane.height - side, side, side};
}

bool axesFit(const render::Pane& pane, double unit) {
    return pane.width >= 60.0 * unit && pane.height >= 40.0 * unit;
}

/// The directions of x, y and z as the camera sees them, in a corner.
void paintAxes(QPainter& painter, const Pen& pen, Corner corner) {
    const render::Camera& camera = render::cameraOf(pen.view, pen.pane.content);
    const Vec3 forward = (camera.focalPoint - camera.position).normalized();
    const Vec3 right = forward.cross(camera.up).normalized();
    const Vec3 up = right.cross(forward);
    if (!right.allFinite() || !axesFit(pen.pane, pen.unit)) {
        return;
    }
    const bool atRight = corner == Corner::UpperRight || corner == Corner::LowerRight;
    const bool above = corner == Corner::UpperRight || corner == Corner::UpperLeft;
    const double in = axesMiddle * pen.unit;
    const QPointF origin(atRight ? pen.pane.x + pen.pane.width - in : pen.pane.x + in,
                         above ? pen.pane.y + in : pen.pane.y + pen.pane.height - in);
    const double length = 6.5 * pen.unit;
    struct Arm {
        char name;
        Vec3 direction;
    };
    std::array<Arm, 3> arms{{{'x', Vec3::UnitX()}, {'y', Vec3::UnitY()}, {'z', Vec3::UnitZ()}}};
    // Those that point away are drawn first.
    std::sort(arms.begin(), arms.end(),
              [&](const Arm& a, const Arm& b) { return a.direction.dot(forward) > b.direction.dot(forward); });
    for (const Arm& arm : arms) {
        const QPointF tip = origin + length * QPointF(arm.direction.dot(right), -arm.direction.dot(up));
        QPainterPath line(origin);
        line.lineTo(tip);
        stroke(painter, pen, line, pen.colours.chipText);
        const QPointF out = tip - origin;
        const double norm = std::hypot(out.x(), out.y());
        const QPointF beyond =
            norm > pen.unit ? tip + out * (2.2 * pen.unit / norm) : tip + QPointF(2.0 * pen.unit, 2.0 * pen.unit);
        painter.setPen(pen.colours.chipText);
        painter.drawText(QRectF(beyond.x() - 2.5 * pen.unit, beyond.y() - 2.5 * pen.unit, 5.0 * pen.unit, 5.0 * pen.unit),
                         Qt::AlignCenter | Qt::TextSingleLine, QString(QLatin1Char(arm.name)));
    }
}

}  // namespace

double axesRoom(double textHeight) {
    return axesSide * unitOf(textHeight);
}

std::optional<Corner> axesCorner(const render::Pane& pane, double textHeight,
                                 const std::function<std::vector<bool>(std::span<const std::array<double, 4>>)>& covered) {
    const double unit = unitOf(textHeight);
    if (!axesFit(pane, unit)) {
        return std::nullopt;
    }
    constexpr std::array<Corner, 4> corners{Corner::UpperRight, Corner::UpperLeft, Corner::LowerRight, Corner::LowerLeft};
    std::array<std::array<double, 4>, 4> squares{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const QRectF square = axesSquare(pane, unit, corners[i]);
        squares[i] = {square.left(), square.top(), square.right(), square.bottom()};
    }
    const std::vector<bool> taken = covered(squares);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!taken[i]) {
            return corners[i];
        }
    }
    return std::nullopt;
}

QString lookingText(const render::Camera& camera, std::optional<double> north) {
    constexpr double steep = 0.97;
    const Vec3 forward = (camera.focalPoint - camera.position).normalized();
    const auto degrees = [](double radians) {
        const long whole = std::lround(radians / std::numbers::pi * 180.0) % 360;
        return static_cast<int>(whole < 0 ? whole + 360 : whole);
    };
    if (!(std::abs(forward.z()) < steep)) {
        const int turned = degrees(std::atan2(camera.up.x(), camera.up.y()) - north.value_or(0.0));
        const int up = forward.z() < 0.0 ? (360 - turned) % 360 : turned;
        if (north) {
            return up == 0 ? tr("north is up") : tr("north %1° clockwise from up").arg(up);
        }
        return up == 0 ? tr("y is up") : tr("y %1° clockwise from up").arg(up);
    }
    if (!north) {
        return tr("looking %1° from x towards y").arg(degrees(std::atan2(forward.y(), forward.x())));
    }
    const int heading = degrees(std::atan2(forward.x(), forward.y()) - *north);
    const std::array<QString, 8> names{tr("north"), tr("north-east"), tr("east"), tr("south-east"),
                                       tr("south"), tr("south-west"), tr("west"), tr("north-west")};
    return tr("looking %1 (%2°)").arg(names[static_cast<std::size_t>((heading + 22) / 45 % 8)]).arg(heading);
}

QString measuredText(double length) {
    const ShownUnit unit = shownUnit("m");
    const int decimals = (length < 100.0 ? 2 : 1) - (unit.perSi > 100.0 ? 3 : 0);
    return QLocale().toString(length * unit.perSi, 'f', std::max(0, decimals)) + u' ' + unit.name;
}

void paintMarks(QPainter& painter, const render::View& view, const render::Pane& pane, double textHeight,
                std::optional<Corner> axes) {
    Pen pen{view, pane, palette(view.theme), {}, unitOf(textHeight)};
    pen.font.setPixelSize(std::max(6, static_cast<int>(std::lround(textHeight))));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(pen.font);
    painter.setClipRect(QRectF(pane.x, pane.y, pane.width, pane.height));
    if (!view.path.empty() && pane.content != render::PaneContent::Fe) {
        paintPath(painter, pen);
    }
    for (const render::Measurement& measured : view.measurements) {
        paintMeasurement(painter, pen, measured);
    }
    if (view.axes && axes) {
        paintAxes(painter, pen, *axes);
    }
    painter.restore();
}

}  // namespace rubble::figures
