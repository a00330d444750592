#include "widgets/figures/camera_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rubble::figures {

namespace {

constexpr int largestView = 4096;  // px
constexpr double widest = 5.0;     // tangent of half the view's angle: a wider view is stretched beyond use
constexpr int patch = 16;          // px: within so many, where pixels look is interpolated

/// The view without distortion that holds all that a photograph shows.
struct PlainView {
    QSize pixels;
    double focal = 1.0;    ///< px
    double tangent = 1.0;  ///< of half its angle, upright

    PlainView(const CameraModel& camera, QSize photograph, double scale) {
        double across = 0.0;
        double up = 0.0;
        constexpr int samples = 32;
        const auto take = [&](double x, double y) {
            const Vec3 ray = rayOf(camera, {x, y});
            across = std::max(across, std::abs(ray.x() / ray.z()));
            up = std::max(up, std::abs(ray.y() / ray.z()));
        };
        for (int k = 0; k <= samples; ++k) {
            const double share = static_cast<double>(k) / samples;
            take(share * photograph.width(), 0.0);
            take(share * photograph.width(), photograph.height());
            take(0.0, share * photograph.height());
            take(photograph.width(), share * photograph.height());
        }
        across = std::min(across, widest);
        up = std::min(up, widest);
        focal = std::min({camera.focal * scale, 0.5 * largestView / across, 0.5 * largestView / up});
        pixels = QSize(std::max(16, static_cast<int>(std::ceil(2.0 * focal * across))),
                       std::max(16, static_cast<int>(std::ceil(2.0 * focal * up))));
        tangent = 0.5 * pixels.height() / focal;
    }
    /// px, where a pixel of the photograph looks.
    QPointF place(const CameraModel& camera, double x, double y) const {
        const Vec3 ray = rayOf(camera, {x, y});
        return {0.5 * pixels.width() + focal * ray.x() / ray.z(), 0.5 * pixels.height() + focal * ray.y() / ray.z()};
    }
};

QRgb sampled(const QImage& image, double x, double y) {
    const double u = std::clamp(x - 0.5, 0.0, image.width() - 1.0);
    const double v = std::clamp(y - 0.5, 0.0, image.height() - 1.0);
    const int i = std::min(static_cast<int>(u), image.width() - 2);
    const int j = std::min(static_cast<int>(v), image.height() - 2);
    const auto* upper = reinterpret_cast<const QRgb*>(image.constScanLine(j)) + i;
    const auto* lower = reinterpret_cast<const QRgb*>(image.constScanLine(j + 1)) + i;
    const double a = u - i;
    const double b = v - j;
    const auto mix = [&](int (*channel)(QRgb)) {
        const double top = (1.0 - a) * channel(upper[0]) + a * channel(upper[1]);
        const double bottom = (1.0 - a) * channel(lower[0]) + a * channel(lower[1]);
        return static_cast<int>(std::lround((1.0 - b) * top + b * bottom));
    };
    return qRgb(mix(qRed), mix(qGreen), mix(qBlue));
}

/// Every pixel looks into the plain picture; where, is reckoned at the corners of patches.
QImage looked(const QImage& plain, const PlainView& view, const CameraModel& camera, QSize size, double scale) {
    QImage picture(size, QImage::Format_RGB32);
    const int columns = (size.width() + patch - 1) / patch + 1;
    const int rows = (size.height() + patch - 1) / patch + 1;
    std::vector<QPointF> corners;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            corners.push_back(view.place(camera, (i * patch + 0.5) / scale, (j * patch + 0.5) / scale));
        }
    }
    for (int y = 0; y < size.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        const double b = static_cast<double>(y % patch) / patch;
        const QPointF* corner = corners.data() + static_cast<std::ptrdiff_t>(y / patch) * columns;
        for (int x = 0; x < size.width(); ++x) {
            const QPointF* at = corner + x / patch;
            const double a = static_cast<double>(x % patch) / patch;
            const QPointF place = (1.0 - b) * ((1.0 - a) * at[0] + a * at[1]) + b * ((1.0 - a) * at[columns] + a * at[columns + 1]);
            line[x] = sampled(plain, place.x(), place.y());
        }
    }
    return picture;
}

}  // namespace

render::Camera viewCamera(const CameraModel& camera, int height, double distance) {
    const Quat toWorld = camera.toCamera.conjugate();
    render::Camera view;
    view.position = camera.place;
    view.focalPoint = camera.place + distance * (toWorld * Vec3::UnitZ());
    view.up = toWorld * Vec3(0.0, -1.0, 0.0);
    view.viewAngle = 2.0 * std::atan(0.5 * height / camera.focal) * 180.0 / std::numbers::pi;
    return view;
}

QImage CameraStudio::picture(const render::View& like, const CameraModel& camera, QSize photograph, int longestSide,
                             double distance) {
    const double scale = std::min(1.0, static_cast<double>(longestSide) / std::max({photograph.width(), photograph.height(), 1}));
    const QSize size(std::max(16, static_cast<int>(std::lround(scale * photograph.width()))),
                     std::max(16, static_cast<int>(std::lround(scale * photograph.height()))));
    const PlainView plain(camera, photograph, scale);
    render::View view = like;
    view.layout = render::Layout::FragmentsOnly;
    view.captions = view.legends = view.scaleBar = view.axes = false;
    view.basicGrid.reset();
    view.selection.clear();
    view.cameras.fill(viewCamera(camera, 1, distance));
    for (render::Camera& each : view.cameras) {
        each.viewAngle = 2.0 * std::atan(plain.tangent) * 180.0 / std::numbers::pi;
    }
    FigureStyle style;
    style.pixels = plain.pixels;
    style.framed = false;
    return looked(m_studio.picture(view, style).convertToFormat(QImage::Format_RGB32), plain, camera, size, scale);
}

}  // namespace rubble::figures
