#pragma once

#include <cstddef>

#include "core/engine/soft/contact_finder.h"
#include "core/engine/soft/solver_assembly.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Takes what a step's substeps have made of bodies and pieces: where they are and how they move.
class BodyResults {
public:
    BodyResults(const AssemblyScene& scene, const SolverAssembly& assembly, const SiteSurface& surface, ContactFinder& finder)
        : m_scene(scene), m_assembly(assembly), m_surface(surface), m_finder(finder) {}

    /// The work of lifting is summed in the order of slots.
    /// @param corrected  bodies were brought apart by position
    void take(SoftSolver& solver, bool corrected, double dt, ContactReport& report);

private:
    double correct(SoftSolver& solver, std::size_t slot, double dt) const;
    double keepAboveGround(SoftBody& body, double dt) const;

    AssemblyScene m_scene;
    const SolverAssembly& m_assembly;
    const SiteSurface& m_surface;
    ContactFinder& m_finder;
};

}  // namespace rubble
