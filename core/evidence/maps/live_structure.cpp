#include "core/evidence/maps/live_structure.h"

#include <cmath>

#include "core/analysis/accuracy/settled_world.h"
#include "core/evidence/maps/element_places.h"
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

}  // namespace rubble
