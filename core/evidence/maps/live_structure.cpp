#include "core/evidence/maps/live_structure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/analysis/accuracy/settled_world.h"
#include "core/evidence/maps/element_places.h"
#include "core/evidence/maps/footprint.h"
#include "core/fragments/birth_windows.h"
#include "core/fragments/element_solid.h"

namespace rubble {

namespace {

PlanBox planOf(const CornerMotion& motion) {
    PlanBox plan;
    for (int c = 0; c < motion.corners; ++c) {
        plan.extend(motion.positions.col(c).head<2>().cast<float>());
    }
    return plan;
}

LiveStructure displaced(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                        const FragmentSet& fragments, const Debris& debris, const ElementPlaces& places, double threshold,
                        const Execution& execution) {
    const Mesh& mesh = fe.mesh();
    std::vector<bool> isFragment(mesh.elementCount(), false);
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        isFragment[at(fragments.list[f].element)] = isFragment[at(fragments.list[f].element)] || debris.fragments[f].present;
    }
    LiveStructure live;
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        if (i % 4096 == 0) {
            execution.check();
        }
        const ElementIndex e = idAt<ElementIndex>(i);
        const double mass = components.mass(e);
        if (isFragment[i] || !places.alive(e) || !(mass > 0.0) || !std::isfinite(mass)) {
            continue;
        }
        CornerMotion motion;
        Vec3 moved = Vec3::Zero();
        for (const std::uint32_t node : mesh.cornersOf(e)) {
            const Vec3 place = places.place(e, node);
            motion.positions.col(motion.corners++) = place;
            moved += place - mesh.nodes[node];
        }
        if (!motion.positions.allFinite()) {
            continue;
        }
        const double way = (moved / motion.corners).norm();
        if (way <= threshold) {
            live.standing.push_back(planOf(motion));
        }
        // Written so that what is no number is left out of both.
        if (!(way > threshold)) {
            continue;
        }
        const LeastExtents extents{settings.minimumThicknessRatio, settings.minimumHalfExtent};
        const ElementSolid solid = elementSolid(mesh, e, motion, components.section[i], extents);
        const OrientedBox& box = solid.sound.box;
        live.pieces.push_back({box, box.centre, mass, components.volume[i], static_cast<std::uint32_t>(at(components.of[i]))});
        live.mass += mass;
        live.volume += components.volume[i];
    }
    return live;
}

}  // namespace

LiveStructure displacedStructure(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                                 const FragmentSet& fragments, const Debris& debris, const TrajectoryReader& trajectory,
                                 double threshold, const Execution& execution) {
    const Activity activity = simulatedActivity(fe, settings);
    const ElementPlaces places(fe, activity, fragments, trajectory, debris.time);
    return displaced(fe, components, settings, fragments, debris, places, threshold, execution);
}

LiveStructure displacedStructure(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                                 const FragmentSet& fragments, const Debris& debris, std::span<const CarriedIsland> islands,
                                 double threshold, const Execution& execution) {
    const Activity activity = simulatedActivity(fe, settings);
    const ElementPlaces places(fe, activity, islands, debris.time);
    return displaced(fe, components, settings, fragments, debris, places, threshold, execution);
}

std::vector<OutlineRing> standingOutline(std::span<const PlanBox> standing, double cell, const Execution& execution) {
    // A box that ends where a cell begins does not reach into it; floats are off by a little.
    constexpr double little = 1e-4;
    const auto first = [cell](float place) { return static_cast<std::int32_t>(std::floor(place / cell + little)); };
    const auto last = [cell](float place) { return static_cast<std::int32_t>(std::ceil(place / cell - little)) - 1; };
    std::vector<MapCell> cells;
    const auto settle = [&cells] {
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    };
    std::size_t settled = 0;
    for (const PlanBox& box : standing) {
        const std::int32_t west = first(box.min().x()), east = std::max(west, last(box.max().x()));
        const std::int32_t south = first(box.min().y()), north = std::max(south, last(box.max().y()));
        for (std::int32_t j = south; j <= north; ++j) {
            for (std::int32_t i = west; i <= east; ++i) {
                cells.push_back({j, i});
            }
        }
        // Elements lie above each other: what was told twice is put away as it doubles.
        if (cells.size() > 2 * settled + 65536) {
            execution.check();
            settle();
            settled = cells.size();
        }
    }
    settle();
    std::vector<OutlineRing> rings;
    const auto take = [&](const FootprintRing& ring) {
        OutlineRing& corners = rings.emplace_back();
        for (const MapCell& corner : ring) {
            corners.emplace_back(cell * corner.i, cell * corner.j);
        }
    };
    for (const FootprintPolygon& polygon : footprintOf(cells)) {
        take(polygon.outer);
        std::for_each(polygon.holes.begin(), polygon.holes.end(), take);
    }
    return rings;
}

}  // namespace rubble
