#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/engine/soft/solver_assembly.h"

namespace rubble {

/// Takes what a step's substeps have made of the contacts: impulses that are carried on, work, loads, and which frozen bodies lost
/// what they rest on.
class ContactResults {
public:
    ContactResults(const AssemblyScene& scene, SolverAssembly& assembly) : m_scene(scene), m_assembly(assembly) {}

    /// Sums are made in the order of the solver's contacts.
    /// @param corrected  bodies were brought apart by position
    void take(SoftSolver& solver, bool corrected, ContactReport& report);
    /// Frozen bodies whose loads changed in this step.
    const std::vector<std::uint32_t>& unloaded() const { return m_unloaded; }

private:
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
    /// What the solver made of a contact.
    struct Outcome {
        double work = 0.0;                ///< J, of a contact that accounts for it
        std::uint32_t points = 0;         ///< if one of them acted
        std::uint32_t unloaded = nobody;  ///< a frozen body
        bool driven = false;              ///< the work is that of a piece
        double strikesA = noPush;         ///< J/kg, of the fastest point of b that pushes a, where a may not have that itself
        double strikesB = noPush;
    };
    Outcome outcomeOf(const SoftSolver& solver, const SolverContact& of, const ContactOutcome& c, bool corrected) const;
    double pressedByCorrection(const SoftSolver& solver, const SolverContact& of, const SoftContact& contact) const;
    void accountForPiece(const SoftSolver& solver, const SolverContact& of, SoftContact& contact, double pushed) const;
    double strikes(bool byA, const SoftSolver& solver, const SolverContact& of, const ContactOutcome& c,
                   const SoftContact& contact) const;
    void handOn(const SoftSolver& solver) const;
    Vec3 loadOf(const SoftContact& contact) const;
    std::uint32_t unloadedBy(const SoftContact& contact) const;

    AssemblyScene m_scene;
    SolverAssembly& m_assembly;
    std::vector<Outcome> m_outcomes;  ///< [contacts of the solver]
    std::vector<std::uint32_t> m_unloaded;
};

}  // namespace rubble
