#include "core/evidence/ensembles/member_surface.h"

#include <algorithm>

#include "core/evidence/maps/live_structure.h"

namespace rubble {

std::ptrdiff_t MemberSurface::find(MapCell cell) const {
    const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
    return found != cells.end() && *found == cell ? found - cells.begin() : -1;
}

bool MemberSurface::covers(std::ptrdiff_t at, bool reached) const {
    return at >= 0 && (reached || double{covered[static_cast<std::size_t>(at)]} >= coveredLeast);
}

MemberSurface surfaceOf(const MemberSite& site, const SurfaceSettings& settings, const Execution& execution) {
    std::vector<MapPiece> pieces;
    for (const DebrisFragment& lies : site.debris->fragments) {
        if (lies.present) {
            pieces.push_back({lies.box, lies.centre, lies.mass, lies.volume});
        }
    }
    if (settings.withFallen) {
        const LiveStructure live = displacedStructure(*site.fe, *site.components, site.scenario->fragments, *site.fragments,
                                                      *site.debris, *site.islands, settings.liveThreshold, execution);
        pieces.insert(pieces.end(), live.pieces.begin(), live.pieces.end());
    }
    const PieceRaster raster = rasterOf(pieces, settings.cell, *site.ground, execution);
    const double area = settings.cell * settings.cell;
    MemberSurface surface;
    surface.cells = raster.cells;
    surface.heights.assign(raster.height.begin(), raster.height.end());
    surface.covered.assign(raster.covered.begin(), raster.covered.end());
    surface.masses.reserve(raster.mass.size());
    for (const double mass : raster.mass) {
        surface.masses.push_back(static_cast<float>(mass / area));
    }
    return surface;
}

}  // namespace rubble
