#include "core/engine/world/ground_contact.h"

#include <algorithm>
#include <array>
#include <limits>

namespace rubble {

namespace {

constexpr std::size_t mostCandidates = 128;

struct Corner {
    Vec3 place;
    double gap = 0.0;  ///< m above the surface, along z
    std::uint32_t feature = 0;
};

/// Corners closer to the ground than `gapLimit`, at most mostCandidates.
std::size_t nearCorners(const SiteSurface& ground, const ConvexPart& part, const Pose& body, double gapLimit,
                        std::array<Corner, mostCandidates>& corners) {
    std::size_t count = 0;
    const auto consider = [&](const Vec3& p, std::uint32_t feature) {
        const double gap = p.z() - ground.height(p.x(), p.y());
        if (gap < gapLimit && count < mostCandidates) {
            corners[count++] = {p, gap, feature};
        }
    };
    if (part.points.empty()) {
        const Mat3 axes = (body.orientation * part.box.orientation).toRotationMatrix();
        const Vec3 centre = body * part.box.centre;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const Vec3 sign(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
            consider(centre + axes * sign.cwiseProduct(part.box.halfExtents), i);
        }
    } else {
        const Mat3 axes = body.orientation.toRotationMatrix();
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            consider(body.position + axes * part.points[i], static_cast<std::uint32_t>(i));
        }
    }
    return count;
}

void levelPatch(std::array<Corner, mostCandidates>& corners, std::size_t count, std::vector<ContactPatch>& patches) {
    std::array<PlanePoint, mostCandidates> points;
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = {corners[i].place.x(), corners[i].place.y(), corners[i].gap, static_cast<std::uint32_t>(i)};
    }
    if (count > 4 && count <= 8) {
        // Of a box the four lowest corners are a face.
        std::stable_sort(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                         [](const PlanePoint& x, const PlanePoint& y) { return x.height < y.height; });
        count = 4;
    }
    ContactPatch patch;
    patch.count = reduceToFour(std::span(points).first(count));
    for (int i = 0; i < patch.count; ++i) {
        const Corner& corner = corners[points[static_cast<std::size_t>(i)].feature];
        patch.points[static_cast<std::size_t>(i)] = {corner.place - Vec3(0.0, 0.0, 0.5 * corner.gap), corner.gap, corner.feature};
    }
    patch.separation = std::numeric_limits<double>::infinity();
    for (const PatchPoint& point : std::span(patch.points).first(static_cast<std::size_t>(patch.count))) {
        patch.separation = std::min(patch.separation, point.separation);
    }
    patches.push_back(patch);
}

/// Where a corner first meets the surface on its way through one step; its present place if it does not.
Vec3 meetingPlace(const SiteSurface& ground, const Vec3& from, const Vec3& travel) {
    constexpr int samples = 16;
    for (int i = 1; i <= samples; ++i) {
        const Vec3 p = from + travel * (static_cast<double>(i) / samples);
        if (p.z() < ground.height(p.x(), p.y())) {
            return p;
        }
    }
    return from;
}

}  // namespace

void collideGround(const SiteSurface& ground, const ConvexPart& part, const Pose& body, const Vec3& velocity, double dt,
                   double margin, std::vector<ContactPatch>& patches) {
    std::array<Corner, mostCandidates> corners;
    if (!ground.terrain) {
        const std::size_t count = nearCorners(ground, part, body, margin, corners);
        if (count > 0) {
            levelPatch(corners, count, patches);
        }
        return;
    }
    const Vec3 travel = velocity * dt;
    const bool far = std::max(std::abs(travel.x()), std::abs(travel.y())) > 0.25 * ground.terrain->cell();
    // A slope may rise towards a corner that is still well above what lies below it.
    const std::size_t count =
        nearCorners(ground, part, body, far ? std::numeric_limits<double>::infinity() : 4.0 * margin, corners);
    for (std::size_t i = 0; i < count; ++i) {
        const Corner& corner = corners[i];
        const Vec3 under = far && corner.gap > 0.0 ? meetingPlace(ground, corner.place, travel) : corner.place;
        ContactPatch patch;
        patch.normal = ground.terrain->normal(under.x(), under.y());
        const Vec3 surface(under.x(), under.y(), ground.height(under.x(), under.y()));
        const double separation = patch.normal.dot(corner.place - surface);
        if (separation < margin) {
            patch.count = 1;
            patch.separation = separation;
            patch.points[0] = {corner.place - 0.5 * separation * patch.normal, separation, corner.feature};
            patches.push_back(patch);
        }
    }
}

}  // namespace rubble
