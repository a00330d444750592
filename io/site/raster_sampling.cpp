#include "io/site/raster_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble::io {

namespace {

constexpr std::size_t stride = 16;  ///< nodes between those that are projected

}  // namespace

/// Places along x and y.
struct RasterSampling::Nodes {
    Eigen::Vector2d first;
    double step;
    std::size_t nx;
    std::size_t ny;

    Eigen::Vector2d at(std::size_t i, std::size_t j) const {
        return first + step * Eigen::Vector2d(static_cast<double>(i), static_cast<double>(j));
    }
};

RasterSampling::RasterSampling(const RasterFile& file, const std::string& crs, const SitePlace& place)
    : m_file(file), m_crs(crs), m_place(place) {}

std::vector<Eigen::Vector2d> RasterSampling::pixelsOf(std::vector<Eigen::Vector2d> places) const {
    for (Eigen::Vector2d& place : places) {
        place = m_place.toWorld(Vec3(place.x(), place.y(), 0.0)).head<2>();
    }
    m_file.toPixels(m_crs, places);
    return places;
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> RasterSampling::bounds() const {
    constexpr int samples = 32;
    const Eigen::Vector2d last(static_cast<double>(m_file.place().columns - 1), static_cast<double>(m_file.place().rows - 1));
    std::vector<Eigen::Vector2d> rim;
    for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        rim.emplace_back(share * last.x(), 0.0);
        rim.emplace_back(share * last.x(), last.y());
        rim.emplace_back(0.0, share * last.y());
        rim.emplace_back(last.x(), share * last.y());
    }
    m_file.fromPixels(m_crs, rim);
    constexpr double far = std::numeric_limits<double>::infinity();
    Eigen::Vector2d low(far, far);
    Eigen::Vector2d high(-far, -far);
    for (const Eigen::Vector2d& place : rim) {
        if (place.allFinite()) {
            const Vec3 local = m_place.toLocal(Vec3(place.x(), place.y(), 0.0));
            low = low.cwiseMin(local.head<2>());
            high = high.cwiseMax(local.head<2>());
        }
    }
    return {low, high};
}

double RasterSampling::pixelSize(const Eigen::Vector2d& local) const {
    const std::vector<Eigen::Vector2d> pixels =
        pixelsOf({local, local + Eigen::Vector2d(1.0, 0.0), local + Eigen::Vector2d(0.0, 1.0)});
    const Eigen::Vector2d east = pixels[1] - pixels[0];
    const Eigen::Vector2d north = pixels[2] - pixels[0];
    // Rows of the change say how many columns and rows a metre crosses at most.
    const double most = std::max(std::hypot(east.x(), north.x()), std::hypot(east.y(), north.y()));
    if (!(most > 0.0) || !std::isfinite(most)) {
        throw UsageError({"terrain.no_scale", "The raster has no place at the site in the system of the case", {}},
                         {"terrain.no_scale.remedy", "Check the coordinate system and the control points of the case.", {}});
    }
    return 1.0 / most;
}

std::vector<Eigen::Vector2d> RasterSampling::pixelsOf(const Nodes& nodes, const Execution& execution) const {
    const auto count = [](std::size_t n) { return (n - 1 + stride - 1) / stride + 1; };
    const std::size_t columns = count(nodes.nx);
    const std::size_t rows = count(nodes.ny);
    std::vector<Eigen::Vector2d> coarse;
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            coarse.push_back(nodes.at(i * stride, j * stride));
        }
    }
    coarse = pixelsOf(std::move(coarse));
    std::vector<Eigen::Vector2d> fine;
    fine.reserve(nodes.nx * nodes.ny);
    for (std::size_t j = 0; j < nodes.ny; ++j) {
        execution.check();
        const std::size_t b = std::min(j / stride, rows > 1 ? rows - 2 : 0);
        const double t = static_cast<double>(j - b * stride) / stride;
        for (std::size_t i = 0; i < nodes.nx; ++i) {
            const std::size_t a = std::min(i / stride, columns > 1 ? columns - 2 : 0);
            const double s = static_cast<double>(i - a * stride) / stride;
            const Eigen::Vector2d* low = &coarse[b * columns + a];
            const Eigen::Vector2d* high = low + (rows > 1 ? columns : 0);
            const std::size_t next = columns > 1 ? 1 : 0;
            fine.emplace_back((1.0 - t) * ((1.0 - s) * low[0] + s * low[next]) + t * ((1.0 - s) * high[0] + s * high[next]));
        }
    }
    return fine;
}

RasterLattice RasterSampling::lattice(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell) const {
    RasterLattice lattice;
    lattice.x0 = low.x();
    lattice.y0 = low.y();
    lattice.pixel = cell;
    lattice.step = static_cast<double>(stride) * cell;
    const auto count = [&](double size) {
        return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(size / lattice.step)) + 1);
    };
    lattice.nx = count(high.x() - low.x());
    lattice.ny = count(high.y() - low.y());
    for (std::size_t j = 0; j < lattice.ny; ++j) {
        for (std::size_t i = 0; i < lattice.nx; ++i) {
            lattice.pixels.push_back(low + lattice.step * Eigen::Vector2d(static_cast<double>(i), static_cast<double>(j)));
        }
    }
    lattice.pixels = pixelsOf(std::move(lattice.pixels));
    return lattice;
}

RasterWindow RasterSampling::windowAround(const std::vector<Eigen::Vector2d>& pixels, std::size_t factor) const {
    const Eigen::Vector2d most(static_cast<double>(m_file.place().columns - 1), static_cast<double>(m_file.place().rows - 1));
    Eigen::Vector2d low = most;
    Eigen::Vector2d high(0.0, 0.0);
    for (const Eigen::Vector2d& pixel : pixels) {
        if (pixel.allFinite()) {
            low = low.cwiseMin(pixel);
            high = high.cwiseMax(pixel);
        }
    }
    low = (low.array() - static_cast<double>(factor)).max(0.0).floor();
    high = (high.array() + static_cast<double>(factor)).min(most.array()).ceil();
    if (!(low.x() <= high.x() && low.y() <= high.y())) {
        return {};
    }
    const auto whole = [&](double from, double to) {
        const auto count = static_cast<std::size_t>(to - from) + 1;
        return count - count % factor;
    };
    return {static_cast<std::size_t>(low.x()), static_cast<std::size_t>(low.y()), whole(low.x(), high.x()),
            whole(low.y(), high.y()), factor};
}

namespace {

/// A place among the pixels that were read, those put together counted as one.
Eigen::Vector2d within(const Eigen::Vector2d& pixel, const RasterWindow& window) {
    const double half = 0.5 * static_cast<double>(window.factor - 1);
    const Eigen::Vector2d first(static_cast<double>(window.column) + half, static_cast<double>(window.row) + half);
    return (pixel - first) / static_cast<double>(window.factor);
}

double between(const std::vector<double>& values, const RasterWindow& window, const Eigen::Vector2d& at) {
    const auto i = std::min(static_cast<std::size_t>(at.x()), window.width() - 2);
    const auto j = std::min(static_cast<std::size_t>(at.y()), window.height() - 2);
    const double s = at.x() - static_cast<double>(i);
    const double t = at.y() - static_cast<double>(j);
    const double* low = &values[j * window.width() + i];
    const double* high = low + window.width();
    const auto part = [](double weight, double height) { return weight > 1e-9 ? weight * height : 0.0; };
    return part((1.0 - t) * (1.0 - s), low[0]) + part((1.0 - t) * s, low[1]) + part(t * (1.0 - s), high[0]) + part(t * s, high[1]);
}

}  // namespace

void RasterSampling::countWithin(const RasterWindow& window, RasterLattice& lattice) {
    for (Eigen::Vector2d& pixel : lattice.pixels) {
        pixel = within(pixel, window);
    }
}

std::vector<Eigen::Vector2d> RasterSampling::placesOf(const RasterWindow& window, const std::vector<std::size_t>& which) const {
    const double half = 0.5 * static_cast<double>(window.factor - 1);
    std::vector<Eigen::Vector2d> places;
    for (const std::size_t k : which) {
        const std::size_t column = k % window.width();
        const std::size_t row = k / window.width();
        const Eigen::Vector2d read(static_cast<double>(column), static_cast<double>(row));
        const Eigen::Vector2d first(static_cast<double>(window.column) + half, static_cast<double>(window.row) + half);
        places.emplace_back(first + static_cast<double>(window.factor) * read);
    }
    m_file.fromPixels(m_crs, places);
    for (Eigen::Vector2d& place : places) {
        place = m_place.planToLocal(place);
    }
    return places;
}

std::vector<double> RasterSampling::heights(const HeightGrid& nodes, std::size_t factor, const Look& look,
                                            const Execution& execution) const {
    const std::vector<Eigen::Vector2d> pixels = pixelsOf(Nodes{{nodes.x0, nodes.y0}, nodes.dx, nodes.nx, nodes.ny}, execution);
    const RasterWindow window = windowAround(pixels, factor);
    std::vector<double> all(pixels.size(), unknown);
    if (window.width() < 2 || window.height() < 2) {
        return all;
    }
    std::vector<double> values = m_file.values(window, execution);
    look(window, values);
    const Eigen::Vector2d last(static_cast<double>(window.width() - 1), static_cast<double>(window.height() - 1));
    constexpr double rounding = 1e-6;  // that the rim of the raster may be missed by
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const Eigen::Vector2d at = within(pixels[k], window);
        const Eigen::Vector2d inside = at.cwiseMax(0.0).cwiseMin(last);
        if ((at - inside).cwiseAbs().maxCoeff() < rounding) {
            all[k] = between(values, window, inside);
        }
    }
    return all;
}

void RasterSampling::colour(Orthophoto& picture, std::size_t factor, const Execution& execution, Findings& findings) const {
    const Eigen::Vector2d first(picture.x0 + 0.5 * picture.pixel, picture.y0 + 0.5 * picture.pixel);
    const std::vector<Eigen::Vector2d> pixels = pixelsOf(
        Nodes{first, picture.pixel, static_cast<std::size_t>(picture.width), static_cast<std::size_t>(picture.height)}, execution);
    picture.rgba.assign(4 * pixels.size(), 0);
    const RasterWindow window = windowAround(pixels, factor);
    if (window.width() < 1 || window.height() < 1) {
        return;
    }
    const std::vector<std::uint8_t> colours = m_file.colours(window, execution, findings);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const Eigen::Vector2d at = within(pixels[k], window).array().round();
        if (at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(window.width()) &&
            at.y() < static_cast<double>(window.height())) {
            const std::size_t from = static_cast<std::size_t>(at.y()) * window.width() + static_cast<std::size_t>(at.x());
            std::copy_n(&colours[4 * from], 4, &picture.rgba[4 * k]);
        }
    }
}

}  // namespace rubble::io
