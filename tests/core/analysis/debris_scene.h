#pragma once

#include <random>

#include "core/analysis/debris/debris.h"

namespace rubble::analysis_scene {

/// A cube-like box that lies at a place, of 1 m3 unless said otherwise.
inline DebrisFragment boxAt(const Vec3& centre, double mass, const Vec3& half = Vec3::Constant(0.5),
                            const Quat& turn = Quat::Identity()) {
    DebrisFragment lies;
    lies.present = true;
    lies.centre = centre;
    lies.box = {centre, turn, half};
    lies.mass = mass;
    lies.volume = lies.box.volume();
    return lies;
}

inline Debris debrisFrom(std::vector<DebrisFragment> fragments) {
    Debris debris;
    debris.time = 1.0;
    debris.fragments = std::move(fragments);
    return debris;
}

/// Tumbled blocks of 0.2 to 1.6 m over an area, as a pile leaves them. The same seed gives the same field.
inline Debris randomField(unsigned seed, std::size_t count, double reach) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
    Debris debris;
    debris.time = 1.0;
    for (std::size_t f = 0; f < count; ++f) {
        const Vec3 half(uniform(0.1, 0.8), uniform(0.1, 0.8), uniform(0.1, 0.8));
        const Quat turn = Quat(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)).normalized();
        // More mass in the middle than at the edge.
        const Vec3 centre(reach * uniform(-1, 1) * uniform(0, 1), reach * uniform(-1, 1) * uniform(0, 1), uniform(0.2, 3.0));
        debris.fragments.push_back(boxAt(centre, 2400.0 * 8.0 * half.prod(), half, turn));
    }
    return debris;
}

inline Debris moved(Debris debris, const Vec3& by) {
    for (DebrisFragment& lies : debris.fragments) {
        lies.centre += by;
        lies.box.centre += by;
    }
    return debris;
}

}  // namespace rubble::analysis_scene
