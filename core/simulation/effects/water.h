#pragma once

#include <vector>

#include "core/base/archive.h"
#include "core/scenario/scenario.h"
#include "core/simulation/effects/effect.h"

namespace rubble {

/// Still or evenly flowing water below a level plane, on a body of mass m whose box lies below the plane by the share s of its
/// volume:
///
/// - Buoyancy rho g s V upwards, V the volume of the body's material (a box may hold more or less than that), with the moment of
/// the
///   centroid of the submerged part about the centre of the box (Archimedes; the cut of box and plane is exact, submerged_box.h).
/// - Drag against the velocity w relative to the current: -(1/2 rho C_d s A |w| + c s rho V) w, A the area of the box seen along w,
///   C_d 1.05 (cube face on: Hoerner, Fluid-Dynamic Drag, 1965), c a rate near rest (a setting).
/// - The same for spin: strips of the faces give 1/2 rho C_d s |w_i| w_i L (b^4 + c^4) / 2 about the axis of length L of the box,
/// and
///   the rate c acts on the displaced share of the inertia.
/// - Added mass C_a s rho V (C_a 0.5 for a sphere, 0.67 for a cube: Brennen, A review of added mass, 1982): the body accelerates as
/// if it
///   had it. What contacts gave in the substep before is known from the velocity, so that a body at rest on the bed presses on it
///   with its weight under water and no other.
///
/// Stable at any step: drag, heave and righting moment are taken at the end of the substep (linearised), and the contact term
/// converges as (C_a s rho V / (m + C_a s rho V))^n.
///
/// Limits: no waves, no splash, no lift, no wake; the drag of a body half under water is that share of the whole; drag makes no
/// moment; no added moment of inertia; air that is trapped in a cluster is not there. Wakes nothing: a frozen body stays.
class Water : public Effect {
public:
    /// @param settings  waterLevel is given
    Water(const EffectSettings& settings, double gravity);

    EffectKind kind() const override { return EffectKind::Water; }
    void beforeSubstep(const SubstepBodies& bodies, double h) override;
    double work() const override { return m_work; }
    void keep(Archive& archive) override { archive(m_expected, m_substep, m_work); }

private:
    /// The velocity that a body would have at its next substep without contacts.
    struct Expected {
        Vec3 velocity = Vec3::Zero();
        std::uint64_t substep = 0;  ///< the one after which it holds

        void keep(Archive& archive) { archive(velocity, substep); }
    };
    struct Wet;
    /// A world moves a body in free flight with the mean of its velocity before and after gravity's kick.
    Vec3 meanVelocity(const MovingBody& body, const Vec3& contact, double h) const;
    void carry(MovingBody& body, const Wet& wet, double h);
    void turn(MovingBody& body, const Wet& wet, double h) const;

    double m_level;
    double m_density;
    Vec3 m_current;
    double m_drag;
    double m_linearDrag;
    double m_addedMass;
    double m_gravity;
    std::vector<Expected> m_expected;  ///< [bodies]
    std::uint64_t m_substep = 0;
    double m_work = 0.0;
    std::vector<double> m_works;  ///< J, [moving bodies] in this substep
};

}  // namespace rubble
