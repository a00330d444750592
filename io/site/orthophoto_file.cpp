#include "io/site/orthophoto_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/site/raster_sampling.h"

namespace rubble::io {

namespace {

constexpr double sideMax = 2048.0;  ///< px

}  // namespace

std::shared_ptr<const Orthophoto> readOrthophoto(const std::string& path, const Frame& frame, const Site& site,
                                                 const SiteWindow& window, const Execution& execution, Findings& findings) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        throw WorldError({"orthophoto.missing", "There is no orthophoto {0}", {path}},
                         {"orthophoto.missing.remedy", "Check the path, or leave the orthophoto out.", {}});
    }
    const RasterFile file(path, RasterFile::Holds::Colours);
    if (file.geographic() && frame.crs.empty()) {
        throw ParseError({"orthophoto.degrees", "{0} lies in degrees, and the case does not say where on Earth it is", {path}},
                         {"orthophoto.degrees.remedy", "Give the case the coordinate system of its site, such as EPSG:25832.", {}});
    }
    const SitePlace place(frame, site);
    const RasterSampling sampling(file, frame.crs, place);
    const std::pair<Eigen::Vector2d, Eigen::Vector2d> whole = sampling.bounds();
    const auto within = [&](double beyond) {
        Eigen::Vector2d low = whole.first.array() - beyond;
        Eigen::Vector2d high = whole.second.array() + beyond;
        if (!window.whole()) {
            low = low.cwiseMax(window.plan().min());
            high = high.cwiseMin(window.plan().max());
        }
        return std::pair(low, high);
    };
    const auto [first, last] = within(0.0);
    if (!((last - first).minCoeff() >= 0.0) || !(last - first).allFinite()) {
        throw ParseError({"orthophoto.elsewhere", "{0} does not show the site", {path}},
                         {"orthophoto.elsewhere.remedy", "Check the coordinate system and the control points of the case.", {}});
    }
    const double fine = sampling.pixelSize(0.5 * (first + last));
    // A pixel reaches half a side around its middle.
    const auto [low, high] = within(0.5 * fine);
    const Eigen::Vector2d size = high - low;
    auto picture = std::make_shared<Orthophoto>();
    picture->pixel = std::max(fine, size.maxCoeff() / sideMax);
    picture->x0 = low.x();
    picture->y0 = low.y();
    picture->width = std::max(1, static_cast<int>(size.x() / picture->pixel + 1e-6));
    picture->height = std::max(1, static_cast<int>(size.y() / picture->pixel + 1e-6));
    const double beyond = 0.5 * fine + std::max((low - whole.first).maxCoeff(), (whole.second - high).maxCoeff());
    if (beyond > picture->pixel) {
        addFinding(findings, path,
                   {"orthophoto.cut",
                    "the orthophoto is read from x = {0} to {1}, y = {2} to {3}, ten heights about the structure; it goes on {4} "
                    "beyond, which is cut off",
                    {low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}, {beyond, "m"}}},
                   "none is needed unless debris runs there");
    }
    if (picture->pixel > (1.0 + 1e-6) * fine) {
        const Eigen::Vector2d there = size / fine;
        addFinding(findings, path,
                   {"orthophoto.reduced",
                    "{0} by {1} pixels of {2} are more than can be drawn: the orthophoto is read as {3} by {4} of {5}",
                    {static_cast<std::int64_t>(std::llround(there.x())),
                     static_cast<std::int64_t>(std::llround(there.y())),
                     {fine, "m"},
                     picture->width,
                     picture->height,
                     {picture->pixel, "m"}}},
                   "cut it to the site if finer pixels are needed there");
    }
    const auto factor = static_cast<std::size_t>(std::max(1.0, std::floor(picture->pixel / fine + 1e-9)));
    sampling.colour(*picture, factor, execution, findings);
    file.checkWay(frame.crs, place.planToWorld(0.5 * (low + high)), findings);
    return picture;
}

}  // namespace rubble::io
