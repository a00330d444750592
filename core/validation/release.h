#pragma once

#include <cstdint>
#include <vector>

#include "core/fe/loose_bodies.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// How many bodies begin in a way that cannot be meant, which is the worst, and by how much.
struct ReleaseCount {
    std::int64_t count = 0;
    std::size_t worst = 0;  ///< body
    double measure = 0.0;   ///< m; of `crowded` the bodies that it overlaps
};

/// How bodies lie where they are let go.
struct ReleaseCheck {
    ReleaseCount outside;   ///< where the terrain has no heights
    ReleaseCount below;     ///< their centre lies below the surface, by so much
    ReleaseCount touching;  ///< only a corner does, by so much
};
ReleaseCheck checkRelease(const std::vector<LooseBody>& bodies, const SiteSurface& surface);

/// Bodies that overlap more others, by the boxes around them, than touching neighbours can.
/// @param limit  of such others
ReleaseCount crowded(const std::vector<LooseBody>& bodies, std::int64_t limit);

/// Lifts what begins in the surface straight up until its lowest corner touches it. The count, and the most in m.
ReleaseCount liftOut(std::vector<LooseBody>& bodies, const SiteSurface& surface);

/// Turns every body by a rotation of its own, evenly over all; velocity and spin stay as they are in the world. The same for the
/// same seed and repeat, whatever the other bodies are.
void turnAtRandom(std::vector<LooseBody>& bodies, std::int64_t seed, std::int64_t repeat);

}  // namespace rubble
