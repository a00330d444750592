#pragma once

#include <vector>

#include "core/analysis/accuracy/settled_world.h"
#include "core/evidence/maps/piece_raster.h"

namespace rubble {

/// How debris is laid on the ground to be compared.
struct SurfaceSettings {
    double cell = 0.5;           ///< m
    bool withFallen = true;      ///< fallen live structure is debris
    double liveThreshold = 1.0;  ///< m, farther than this live structure has fallen
    friend bool operator==(const SurfaceSettings&, const SurfaceSettings&) = default;
};

/// Share of a cell from which on an outline covers it, as it is of a survey.
inline constexpr double coveredLeast = 0.5;

/// Debris as it lies, cell by cell. Cells that nothing reaches into are left out.
struct MemberSurface {
    std::vector<MapCell> cells;  ///< ascending
    std::vector<float> heights;  ///< m, mean height of the top above the ground
    std::vector<float> masses;   ///< kg/m2
    std::vector<float> covered;  ///< share of the cell that debris lies in

    /// Place of a cell in the lists; -1 if nothing lies there.
    std::ptrdiff_t find(MapCell cell) const;
    /// Debris covers a cell of the lists; -1: nothing lies there. @param reached  it is enough that debris reaches into it
    bool covers(std::ptrdiff_t at, bool reached) const;
};

/// All that is known of where one simulated world came to lie. Pointers must outlive the call they are given to.
struct MemberSite {
    const FeResult* fe = nullptr;
    const Scenario* scenario = nullptr;
    const Components* components = nullptr;
    const FragmentSet* fragments = nullptr;
    const Debris* debris = nullptr;
    const std::vector<CarriedIsland>* islands = nullptr;
    const SiteSurface* ground = nullptr;
    const MemberSurface* surface = nullptr;  ///< null: not made yet
};

/// Lays the fragments, and if so asked the fallen live structure among them, on a grid. Throws as rasterOf().
MemberSurface surfaceOf(const MemberSite& site, const SurfaceSettings& settings, const Execution& execution);

}  // namespace rubble
