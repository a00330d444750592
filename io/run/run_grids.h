#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/accuracy/settled_world.h"
#include "core/fe/fe_result.h"
#include "io/run/fragment_places.h"
#include "io/run/run_file.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// Cells as VTK numbers them. Points in m, z up, as exportFragments() gives places.
struct CellGrid {
    std::vector<Vec3> points;
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets{0};  ///< [cells + 1]
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> elements;    ///< user's number of each cell's element
    std::vector<std::int32_t> components;  ///< index into the names
    std::vector<std::int32_t> fragments;   ///< of each cell; empty where no cell is one
    std::vector<std::int32_t> clusters;    ///< as fragments; -1: the run was not clustered
    std::vector<float> speeds;             ///< m/s; as fragments

    std::size_t cells() const { return types.size(); }
};

/// An instant that is written: its time, and the FE state whose structure it shows.
struct RunInstant {
    double time = 0.0;  ///< s
    std::size_t state = 0;
};

/// What a run shows as unstructured grids over time, for the exports that others open.
class RunGrids {
public:
    /// Parts of an instant, in this order everywhere.
    static constexpr const char* partNames[] = {"fragments", "structure", "released"};

    /// Both must outlive this object. Throws ParseError, UsageError (not the FE file of the run).
    RunGrids(const RunReader& run, const FeResult& fe);

    /// Every FE state that the run reached and, after the last, frames about as far apart, and the very last one.
    std::vector<RunInstant> instants() const;
    const std::vector<std::string>& componentNames() const { return m_componentNames; }
    /// Points lie so far from the origin that they need double precision.
    bool needsDoublePrecision() const;

    std::vector<FragmentPlaces::Place> places(const RunInstant& instant) const { return m_places.at(instant.time); }
    CellGrid fragments(const std::vector<FragmentPlaces::Place>& shown) const;
    /// Active structure as the FE result has it, without the elements of the fragments shown and of islands that bodies carry.
    CellGrid structure(const RunInstant& instant, const std::vector<FragmentPlaces::Place>& shown) const;
    /// Bodies carry live structure at this instant, which is a part of its own; so is what left it and is not born yet.
    bool hasReleased(const RunInstant& instant) const;
    CellGrid released(const RunInstant& instant) const;

private:
    /// Islands that bodies carry, then what left them and is not born yet.
    std::vector<CarriedIsland> carriedAt(double time) const;

    const RunReader& m_run;
    const FeResult& m_fe;
    FragmentPlaces m_places;
    SitePlace m_site;
    std::vector<std::string> m_componentNames;
    std::vector<ComponentId> m_componentOf;  ///< of each element
    std::vector<std::int64_t> m_elementIds;  ///< of each fragment
    std::shared_ptr<const Clustering> m_clustering;
    std::vector<IslandRecord> m_islands;
    std::vector<BodyRecord> m_bodies;
    std::vector<Carrier> m_carriers;
};

}  // namespace rubble::io
