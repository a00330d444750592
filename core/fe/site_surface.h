#pragma once

#include <algorithm>
#include <limits>
#include <memory>

#include "core/fe/terrain_grid.h"

namespace rubble {

/// What things fall on: a terrain, or else level ground, or nothing at all.
struct SiteSurface {
    bool level = true;                                     ///< there is level ground, unless a terrain takes its place
    double levelHeight = 0.0;                              ///< m, of the level ground; also what heights are measured from
    std::shared_ptr<const TerrainGrid> terrain = nullptr;  ///< null: none

    bool present() const { return level || terrain; }
    /// Height of the surface at a place, m: that of the level ground where there is no terrain.
    double height(double x, double y) const { return terrain ? terrain->height(x, y) : levelHeight; }
    Vec3 normal(double x, double y) const { return terrain ? terrain->normal(x, y) : Vec3(Vec3::UnitZ()); }
    /// How far a point lies below the surface, m, straight down; negative above it and wherever nothing is.
    double depth(const Vec3& p) const {
        return present() ? height(p.x(), p.y()) - p.z() : -std::numeric_limits<double>::infinity();
    }
    /// The nearest place on the surface for a point below it: along the slope's normal, straight up where that does not get there.
    Vec3 above(Vec3 p) const {
        constexpr int tries = 4;  // across as many triangles
        for (int i = 0; terrain && i < tries && depth(p) > 0.0; ++i) {
            const Vec3 up = normal(p.x(), p.y());
            p += depth(p) * up.z() * up;
        }
        p.z() = std::max(p.z(), height(p.x(), p.y()));
        return p;
    }
};

}  // namespace rubble
