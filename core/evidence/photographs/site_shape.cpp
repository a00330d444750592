#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/evidence/maps/element_places.h"
#include "core/evidence/photographs/site_picture.h"
#include "core/fragments/birth_windows.h"

namespace rubble {

namespace {

using Face = std::array<std::int8_t, 4>;

/// Adds a face of a solid whose corners are in a row of points that begins at `first`.
void addFace(SiteShape& site, SiteThing thing, std::uint32_t part, std::uint32_t first, const Face& face) {
    const auto corner = [&](std::size_t k) { return first + static_cast<std::uint32_t>(face[k]); };
    site.triangles.push_back({corner(0), corner(1), corner(2)});
    site.things.push_back(thing);
    site.parts.push_back(part);
    if (face[3] >= 0) {
        site.triangles.push_back({corner(0), corner(2), corner(3)});
        site.things.push_back(thing);
        site.parts.push_back(part);
    }
}

void addDebris(SiteShape& site, const FragmentSet& fragments, const Debris& debris) {
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        if (!debris.fragments[f].present) {
            continue;
        }
        // The box turns and moves with its fragment.
        const OrientedBox& before = fragments.list[f].box;
        const OrientedBox& now = debris.fragments[f].box;
        const Quat turn = now.orientation * before.orientation.conjugate();
        const auto first = static_cast<std::uint32_t>(site.points.size());
        for (const Vec3& vertex : fragments.verticesOf(idAt<FragmentId>(f))) {
            site.points.push_back(now.centre + turn * (vertex - before.centre));
        }
        for (const Face& face : facesOf(fragments.solid[f])) {
            addFace(site, SiteThing::Debris, static_cast<std::uint32_t>(f), first, face);
        }
    }
}

/// Faces of live elements, known by their nodes: those of two solids that touch hide each other.
struct Side {
    std::array<std::uint32_t, 4> key{};  ///< nodes ascending
    std::uint32_t element = 0;
    std::uint32_t face = 0;
};

std::vector<Side> outerSides(const Mesh& mesh, const std::vector<bool>& shown) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!shown[i]) {
            continue;
        }
        const auto corners = mesh.cornersOf(idAt<ElementIndex>(i));
        const auto faces = facesOf(mesh.shapes[i]);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            Side side{{}, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(f)};
            for (std::size_t k = 0; k < 4; ++k) {
                side.key[k] = faces[f][k] >= 0 ? corners[static_cast<std::size_t>(faces[f][k])] : 0xffffffffu;
            }
            std::sort(side.key.begin(), side.key.end());
            sides.push_back(side);
        }
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
    std::vector<Side> outer;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].key == sides[i].key) {
            ++end;
        }
        const bool shell = isShell(mesh.shapes[sides[i].element]);
        if (end == i + 1 || shell) {
            outer.push_back(sides[i]);
        }
        i = end;
    }
    return outer;
}

void addStructure(SiteShape& site, const Mesh& mesh, const ElementPlaces& places, const FragmentSet& fragments,
                  const Debris& debris, double threshold, const Execution& execution) {
    std::vector<bool> shown(mesh.elementCount());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i] = places.alive(idAt<ElementIndex>(i));
    }
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        if (debris.fragments[f].present) {
            shown[at(fragments.list[f].element)] = false;
        }
    }
    execution.check();
    for (const Side& side : outerSides(mesh, shown)) {
        const ElementIndex e = idAt<ElementIndex>(side.element);
        const auto corners = mesh.cornersOf(e);
        Vec3 moved = Vec3::Zero();
        for (const std::uint32_t node : corners) {
            moved += places.place(e, node) - mesh.nodes[node];
        }
        const bool fallen = (moved / static_cast<double>(corners.size())).norm() > threshold;
        const auto first = static_cast<std::uint32_t>(site.points.size());
        for (const std::uint32_t node : corners) {
            site.points.push_back(places.place(e, node));
        }
        addFace(site, fallen ? SiteThing::FallenStructure : SiteThing::Structure, side.element, first,
                facesOf(mesh.shapes[side.element])[side.face]);
    }
}

/// Triangles of the terrain that may hide debris from a camera; what is finer is left out.
constexpr double hidingTriangles = 200000.0;

/// The terrain between the debris and a place.
void addTerrain(SiteShape& site, const SiteSurface& ground, const Vec3& seenFrom) {
    Aabb around(seenFrom);
    for (const Vec3& point : site.points) {
        if (point.allFinite()) {
            around.extend(point);
        }
    }
    addGround(site, ground, around, hidingTriangles);
}

}  // namespace

std::size_t addGround(SiteShape& site, const SiteSurface& ground, const Aabb& around, double trianglesMost) {
    if (!ground.present()) {
        return 1;
    }
    if (!ground.terrain) {
        const auto corner = [&](const Vec3& x, const Vec3& y) { return Vec3(x.x(), y.y(), ground.levelHeight); };
        const Vec3 low = around.min();
        const Vec3 high = around.max();
        site.add(SiteThing::Ground, corner(low, low), corner(high, low), corner(high, high));
        site.add(SiteThing::Ground, corner(low, low), corner(high, high), corner(low, high));
        return 1;
    }
    const TerrainGrid& terrain = *ground.terrain;
    const auto range = [&](double origin, std::size_t count, double from, double to) {
        const double last = static_cast<double>(count - 1);
        return std::pair(static_cast<std::size_t>(std::floor(std::clamp((from - origin) / terrain.cell(), 0.0, last))),
                         static_cast<std::size_t>(std::ceil(std::clamp((to - origin) / terrain.cell(), 0.0, last))));
    };
    const auto [i0, i1] = range(terrain.x0(), terrain.nx(), around.min().x(), around.max().x());
    const auto [j0, j1] = range(terrain.y0(), terrain.ny(), around.min().y(), around.max().y());
    const double cells = static_cast<double>(i1 - i0) * static_cast<double>(j1 - j0);
    const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(std::sqrt(2.0 * cells / trianglesMost))));
    const auto node = [&](std::size_t i, std::size_t j) {
        i = std::min(i, i1);
        j = std::min(j, j1);
        return Vec3(terrain.x0() + static_cast<double>(i) * terrain.cell(), terrain.y0() + static_cast<double>(j) * terrain.cell(),
                    terrain.node(i, j));
    };
    for (std::size_t j = j0; j < j1; j += step) {
        for (std::size_t i = i0; i < i1; i += step) {
            site.add(SiteThing::Ground, node(i, j), node(i + step, j), node(i + step, j + step));
            site.add(SiteThing::Ground, node(i, j), node(i + step, j + step), node(i, j + step));
        }
    }
    return step;
}

SiteShape siteOfRun(const MappedRun& run, std::optional<double> time, double liveThreshold, const Vec3& seenFrom,
                    const Execution& execution) {
    const MapSpan span = mapSpan(run);
    if (!run.fragments || run.trajectory->frameCount() == 0) {
        throw UsageError({"site.nothing_simulated", "Nothing is simulated yet, so there is no debris to see.", {}},
                         {"site.nothing_simulated.remedy", "Simulate the case first.", {}});
    }
    const double when = time.value_or(span.last);
    if (!(when >= span.first && when <= span.last)) {
        throw UsageError({"site.time_outside",
                          "The photograph is of {0}, but the run goes from {1} to {2}.",
                          {{when, "s"}, {span.first, "s"}, {span.last, "s"}}},
                         {"site.time_outside.remedy", "Correct the time of the photograph, or simulate on to it.", {}});
    }
    const Components components =
        groupComponents(run.fe->mesh(), run.scenario.regrouping, run.scenario.components, run.scenario.assumptions);
    Debris debris = debrisAt(*run.fragments, components, *run.trajectory, when);
    debris.time = when;
    const Activity activity = simulatedActivity(*run.fe, run.scenario.fragments);
    SiteShape site;
    site.time = when;
    addDebris(site, *run.fragments, debris);
    const ElementPlaces places(*run.fe, activity, *run.fragments, *run.trajectory, when);
    addStructure(site, run.fe->mesh(), places, *run.fragments, debris, liveThreshold, execution);
    if (const SiteSurface ground = groundOf(run); ground.terrain) {
        addTerrain(site, ground, seenFrom);
    }
    return site;
}

SiteShape siteAtRest(const FeResult& fe, const FragmentSettings& settings, const FragmentSet& fragments, const Debris& debris,
                     std::span<const CarriedIsland> islands, const SiteSurface& ground, double liveThreshold, const Vec3& seenFrom,
                     const Execution& execution) {
    const Activity activity = simulatedActivity(fe, settings);
    SiteShape site;
    site.time = debris.time;
    addDebris(site, fragments, debris);
    const ElementPlaces places(fe, activity, islands, debris.time);
    addStructure(site, fe.mesh(), places, fragments, debris, liveThreshold, execution);
    if (ground.terrain) {
        addTerrain(site, ground, seenFrom);
    }
    return site;
}

}  // namespace rubble
