#include "widgets/figures/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace rubble::figures {
namespace {

constexpr double steep = 1e-6;  // of a direction's level part: below, the upward axis tells where it looks

/// What goes smoothly from key to key: centre [m], turn about z and above the level [rad], logarithms of distance and lens.
enum Track { CentreX, CentreY, CentreZ, Yaw, Pitch, Distance, Angle, Scale, TrackCount };
using Tracks = std::array<double, TrackCount>;

Tracks tracksOf(const CameraKey& key) {
    const Vec3 arm = key.position - key.focalPoint;
    const double distance = std::max(arm.norm(), 1e-9);
    const Vec3 direction = arm / distance;
    // Straight from above the direction has no turn; then the upward axis points away from it.
    const bool upright = direction.head<2>().norm() < steep;
    const Vec3 level = upright ? Vec3(key.up * (direction.z() > 0.0 ? -1.0 : 1.0)) : direction;
    return {key.focalPoint.x(),
            key.focalPoint.y(),
            key.focalPoint.z(),
            std::atan2(level.y(), level.x()),
            std::asin(std::clamp(direction.z(), -1.0, 1.0)),
            std::log(distance),
            std::log(key.viewAngle),
            std::log(key.parallelScale)};
}

/// One key after the other, each turned by less than half a turn from the one before.
std::vector<Tracks> unwound(std::span<const CameraKey> keys) {
    std::vector<Tracks> tracks;
    for (const CameraKey& key : keys) {
        Tracks next = tracksOf(key);
        if (!tracks.empty()) {
            constexpr double turn = 2.0 * std::numbers::pi;
            next[Yaw] += turn * std::round((tracks.back()[Yaw] - next[Yaw]) / turn);
        }
        tracks.push_back(next);
    }
    return tracks;
}

/// Slope of a track at a key, per second: none at the ends and where it turns back, so that nothing swings beyond a key.
double slopeAt(std::span<const CameraKey> keys, const std::vector<Tracks>& tracks, std::size_t key, std::size_t track) {
    if (key == 0 || key + 1 == keys.size()) {
        return 0.0;
    }
    const double before = (tracks[key][track] - tracks[key - 1][track]) / (keys[key].time - keys[key - 1].time);
    const double after = (tracks[key + 1][track] - tracks[key][track]) / (keys[key + 1].time - keys[key].time);
    return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}

render::Camera cameraFrom(const Tracks& at, bool parallel) {
    render::Camera camera;
    const double level = std::cos(at[Pitch]);
    const Vec3 direction(level * std::cos(at[Yaw]), level * std::sin(at[Yaw]), std::sin(at[Pitch]));
    camera.focalPoint = Vec3(at[CentreX], at[CentreY], at[CentreZ]);
    camera.position = camera.focalPoint + std::exp(at[Distance]) * direction;
    camera.up = Vec3(-std::sin(at[Pitch]) * std::cos(at[Yaw]), -std::sin(at[Pitch]) * std::sin(at[Yaw]), level);
    camera.viewAngle = std::exp(at[Angle]);
    camera.parallelScale = std::exp(at[Scale]);
    camera.parallel = parallel;
    return camera;
}

}  // namespace

CameraKey keyOf(const render::Camera& camera, double time) {
    return {time, camera.position, camera.focalPoint, camera.up, camera.viewAngle, camera.parallel, camera.parallelScale};
}

render::Camera cameraOf(const CameraKey& key) {
    return {key.position, key.focalPoint, key.up, key.viewAngle, key.parallel, key.parallelScale};
}

render::Camera cameraAlong(std::span<const CameraKey> keys, double time) {
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), time, [](double t, const CameraKey& key) { return t < key.time; });
    if (after == keys.begin()) {
        return cameraOf(keys.front());
    }
    const auto from = static_cast<std::size_t>(after - keys.begin()) - 1;
    if (after == keys.end() || time == keys[from].time) {
        return cameraOf(keys[from]);
    }
    const std::vector<Tracks> tracks = unwound(keys);
    const double span = keys[from + 1].time - keys[from].time;
    const double s = (time - keys[from].time) / span;
    Tracks at{};
    for (std::size_t track = 0; track < TrackCount; ++track) {
        const double a = tracks[from][track];
        const double b = tracks[from + 1][track];
        const double leaving = span * slopeAt(keys, tracks, from, track);
        const double coming = span * slopeAt(keys, tracks, from + 1, track);
        const double rise = b - a;
        // The cubic with these ends and slopes.
        at[track] = a + s * (leaving + s * (3.0 * rise - 2.0 * leaving - coming + s * (leaving + coming - 2.0 * rise)));
    }
    return cameraFrom(at, keys[from].parallel);
}

void lookAlong(render::View& view, std::span<const CameraKey> keys, double time) {
    if (keys.empty()) {
        return;
    }
    const render::Camera camera = cameraAlong(keys, time);
    for (const render::PaneContent content :
         {render::PaneContent::Fe, render::PaneContent::Fragments, render::PaneContent::Overlay}) {
        render::cameraOf(view, content) = camera;
    }
}

}  // namespace rubble::figures
