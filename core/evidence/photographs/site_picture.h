#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/evidence/maps/run_map.h"
#include "core/evidence/photographs/camera_model.h"

namespace rubble {

/// What a surface belongs to.
enum class SiteThing : std::uint8_t { Nothing, Debris, FallenStructure, Structure, Ground };

/// The surfaces of all that stands and lies on a site at one instant.
struct SiteShape {
    double time = 0.0;                                    ///< s
    std::vector<Vec3> points;                             ///< m
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points
    std::vector<SiteThing> things;                        ///< [triangles]
    std::vector<std::uint32_t> parts;                     ///< [triangles] number of the fragment, or of the element; 0 of ground

    /// Adds a triangle with points of its own.
    void add(SiteThing thing, const Vec3& a, const Vec3& b, const Vec3& c);
};

/// Adds ground within a box in plan: all nodes of a terrain there while there is room, or level ground.
/// @return  by how many nodes at a time the terrain was taken; 1: all of them
std::size_t addGround(SiteShape& site, const SiteSurface& ground, const Aabb& around, double trianglesMost);

/// The site of a run at a time within its span; unset means its end. Live structure that moved farther than a threshold [m] is
/// fallen. Of a terrain that part is taken which may hide debris from a place.
/// Throws UsageError (a time outside the run, nothing simulated), Cancelled, and what reading throws.
SiteShape siteOfRun(const MappedRun& run, std::optional<double> time, double liveThreshold, const Vec3& seenFrom,
                    const Execution& execution);

/// The same from where fragments and released islands lie at an instant at or after the last FE state.
SiteShape siteAtRest(const FeResult& fe, const FragmentSettings& settings, const FragmentSet& fragments, const Debris& debris,
                     std::span<const CarriedIsland> islands, const SiteSurface& ground, double liveThreshold, const Vec3& seenFrom,
                     const Execution& execution);

/// What a camera sees of a site, pixel by pixel.
struct SitePicture {
    double scale = 1.0;  ///< pixels of this picture per pixel of the photograph
    int width = 0;
    int height = 0;
    std::vector<SiteThing> things;  ///< [height * width], of what is nearest, taken at the middle of each pixel
    std::vector<float> depths;      ///< m ahead of the camera; infinite where there is nothing

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Takes the picture that a camera would: every corner is projected with the distortion, edges between are drawn straight; what is
/// not wholly ahead of the camera, or so far off its axis that the distortion folds back, is left out.
/// @param width, height  px, of the photograph
/// @param longestSide    px, of the picture that is made; at most that of the photograph
SitePicture pictureOf(const SiteShape& site, const CameraModel& camera, int width, int height, int longestSide);

/// Tangent of the angle off the axis up to which a camera's distortion grows outwards; infinite if it does so everywhere.
double distortionReach(const CameraModel& camera);

}  // namespace rubble
