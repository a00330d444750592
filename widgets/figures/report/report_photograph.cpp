#include "widgets/figures/report/report_photograph.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <vector>

#include "widgets/figures/palette.h"

namespace rubble::figures {
namespace {

constexpr double drawnWidth = 0.0022;  // of the width of the picture

/// A line with a dark rim, so that it shows on bright and dark.
void stroke(QPainter& painter, const QPolygonF& ring, const QColor& colour, double wide, Qt::PenStyle style) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 2.0 * wide, style, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolygon(ring);
    painter.setPen(QPen(colour, wide, style, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolygon(ring);
}

}  // namespace

QImage photographPicture(const ReportPhoto& photo, int width) {
    if (photo.rgb.empty() || photo.photograph.facts.width <= 0) {
        return {};
    }
    const QImage pixels(photo.rgb.data(), photo.width, photo.height, 3 * photo.width, QImage::Format_RGB888);
    QImage picture = pixels.scaledToWidth(width, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const double scale = static_cast<double>(width) / photo.photograph.facts.width;
    const double wide = std::max(1.0, drawnWidth * width);
    const auto ringOf = [scale](const std::vector<Eigen::Vector2d>& corners) {
        QPolygonF ring;
        for (const Eigen::Vector2d& corner : corners) {
            ring << QPointF(scale * corner.x(), scale * corner.y());
        }
        return ring;
    };
    for (const PhotoMask& mask : photo.photograph.masks) {
        stroke(painter, ringOf(mask.corners), Qt::white, wide, mask.kind == MaskClass::Debris ? Qt::SolidLine : Qt::DotLine);
    }
    if (photo.comparison) {
        for (const auto& ring : photo.comparison->outlines) {
            stroke(painter, ringOf(ring), palette(render::Theme::Light).fragment, wide, Qt::SolidLine);
        }
    }
    return picture;
}

}  // namespace rubble::figures
