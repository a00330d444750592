#include "core/evidence/photographs/site_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

/// A corner in the picture.
struct Corner {
    float x = 0.0F;
    float y = 0.0F;
    float nearness = 0.0F;  ///< 1/m, one over the depth: linear across a triangle; 0: cannot be seen
};

std::vector<Corner> projected(const SiteShape& site, const CameraModel& camera, double scale) {
    const Mat3 turn = camera.toCamera.toRotationMatrix();
    const double reach = distortionReach(camera);
    std::vector<Corner> corners(site.points.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 p = turn * (site.points[i] - camera.place);
        constexpr double nearest = 0.05;  // m
        if (!(p.z() > nearest)) {
            continue;
        }
        const Eigen::Vector2d q = p.head<2>() / p.z();
        const double r2 = q.squaredNorm();
        if (!(r2 < reach * reach)) {
            continue;
        }
        const Eigen::Vector2d at =
            scale * (camera.principal + camera.focal * (1.0 + r2 * (camera.radial[0] + r2 * camera.radial[1])) * q);
        corners[i] = {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(1.0 / p.z())};
    }
    return corners;
}

/// Fills a triangle where it is nearer than what is there.
void fill(SitePicture& picture, std::vector<float>& nearness, const Corner& a, const Corner& b, const Corner& c, SiteThing thing) {
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0.0F || !std::isfinite(area)) {
        return;
    }
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    // Middles of pixels lie at halves.
    const int x0 = static_cast<int>(std::ceil(std::clamp(left - 0.5F, 0.0F, static_cast<float>(picture.width))));
    const int x1 = static_cast<int>(std::floor(std::clamp(right - 0.5F, -1.0F, static_cast<float>(picture.width - 1))));
    const int y0 = static_cast<int>(std::ceil(std::clamp(top - 0.5F, 0.0F, static_cast<float>(picture.height))));
    const int y1 = static_cast<int>(std::floor(std::clamp(bottom - 0.5F, -1.0F, static_cast<float>(picture.height - 1))));
    const float over = 1.0F / area;
    for (int y = y0; y <= y1; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        for (int x = x0; x <= x1; ++x) {
            const float px = static_cast<float>(x) + 0.5F;
            const float ofC = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) * over;
            const float ofB = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) * over;
            const float ofA = 1.0F - ofB - ofC;
            if (ofA < 0.0F || ofB < 0.0F || ofC < 0.0F) {
                continue;
            }
            const float here = ofA * a.nearness + ofB * b.nearness + ofC * c.nearness;
            const std::size_t i = picture.index(x, y);
            if (here > nearness[i]) {
                nearness[i] = here;
                picture.things[i] = thing;
            }
        }
    }
}

}  // namespace

void SiteShape::add(SiteThing thing, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
    things.push_back(thing);
    parts.push_back(0);
}

double distortionReach(const CameraModel& camera) {
    // The distance from the axis in the picture, r (1 + k1 r2 + k2 r4), grows while 1 + 3 k1 r2 + 5 k2 r4 > 0.
    const double k1 = camera.radial[0];
    const double k2 = camera.radial[1];
    constexpr double never = std::numeric_limits<double>::infinity();
    if (k2 == 0.0) {
        return k1 < 0.0 ? std::sqrt(-1.0 / (3.0 * k1)) : never;
    }
    const double root = 9.0 * k1 * k1 - 20.0 * k2;
    if (root < 0.0) {
        return never;
    }
    double reach = never;
    for (const double sign : {-1.0, 1.0}) {
        const double r2 = (-3.0 * k1 + sign * std::sqrt(root)) / (10.0 * k2);
        if (r2 > 0.0) {
            reach = std::min(reach, std::sqrt(r2));
        }
    }
    return reach;
}

SitePicture pictureOf(const SiteShape& site, const CameraModel& camera, int width, int height, int longestSide) {
    SitePicture picture;
    picture.scale = std::min(1.0, static_cast<double>(longestSide) / std::max(width, height));
    picture.width = std::max(1, static_cast<int>(std::lround(picture.scale * width)));
    picture.height = std::max(1, static_cast<int>(std::lround(picture.scale * height)));
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.things.assign(pixels, SiteThing::Nothing);
    std::vector<float> nearness(pixels, 0.0F);
    const std::vector<Corner> corners = projected(site, camera, picture.scale);
    for (std::size_t t = 0; t < site.triangles.size(); ++t) {
        const Corner& a = corners[site.triangles[t][0]];
        const Corner& b = corners[site.triangles[t][1]];
        const Corner& c = corners[site.triangles[t][2]];
        if (a.nearness > 0.0F && b.nearness > 0.0F && c.nearness > 0.0F) {
            fill(picture, nearness, a, b, c, site.things[t]);
        }
    }
    picture.depths.resize(pixels);
    std::transform(nearness.begin(), nearness.end(), picture.depths.begin(),
                   [](float of) { return of > 0.0F ? 1.0F / of : std::numeric_limits<float>::infinity(); });
    return picture;
}

}  // namespace rubble
