#pragma once

#include <cstdint>
#include <vector>

#include "core/base/archive.h"
#include "core/simulation/effects/effect.h"
#include "core/simulation/effects/tie_sites.h"

namespace rubble {

/// A bar of steel between two bodies, by its ends.
struct Tie {
    BodyId a{};
    BodyId b{};
    Vec3 onA = Vec3::Zero();  ///< m, in the frame of a
    Vec3 onB = Vec3::Zero();
    double yieldForce = 0.0;   ///< N
    double stiffness = 0.0;    ///< N/m
    double breakGap = 0.0;     ///< m, distance of its ends at which it breaks
    double slackGap = 0.0;     ///< m, up to which it is slack: grows as it yields
    Vec3 pull = Vec3::Zero();  ///< N s, on a, of the latest substep

    void keep(Archive& archive) { archive(a, b, onA, onB, yieldForce, stiffness, breakGap, slackGap, pull); }
};

/// Reinforcement between neighbouring clusters: where elements of reinforced components share faces, one tie a pair of clusters, of
/// section A_s = tie_ratio times the shared area, between the places of the centre of that area on the two bodies.
///
/// The tie is elastic-perfectly plastic: it pulls its ends together with min(E A_s / L (d - d_p), A_s f_y), d their distance, d_p
/// what has yielded so far, L the distance of the clusters' centres at rest, E = 200 GPa (EN 1992-1-1, 3.2.7); it never pushes, and
/// breaks at d = tie_elongation times L. Shearing opens d as pulling does (dowel action). Strength and elongation are settings (500
/// MPa; EN 1992-1-1 annex C asks for 2.5 to 7.5 % at maximum force, 10 to 20 % at rupture are usual).
///
/// Solved by impulses along the line of the ends, at most a dozen passes a substep, implicit in stiffness with a damping that keeps
/// the elastic part from ringing (relaxation over four substeps); the force, damping included, never passes A_s f_y. Impulses are
/// equal and opposite on one line, so that momentum and angular momentum are kept. A frozen partner holds, and is woken when the
/// force could move it. A tie forms when the later of its two bodies enters; what the gap has opened by then counts as yielded, and
/// a gap beyond the elongation is torn already. A body that leaves takes its ties along.
///
/// Limits: no ties to the live structure; no bond slip, no hardening, no bending stiffness of the bars; one bar at the centre of a
/// shared area lets two clusters turn about it.
class Ties : public Effect {
public:
    /// @param world  must outlive the effect
    Ties(const RunDescription& description, RigidWorld& world);
    ~Ties() override;

    EffectKind kind() const override { return EffectKind::Ties; }
    void entered(std::span<const BodyRecord> bodies, RigidWorld& world) override;
    void leaving(BodyId body) override;
    void beforeSubstep(const SubstepBodies& bodies, double h) override;
    void afterStep(RigidWorld& world, double dt) override;
    double work() const override { return m_work; }
    std::int64_t events() const override { return m_broken; }
    void keep(Archive& archive) override;

    void add(const Tie& tie) { m_ties.push_back(tie); }
    const std::vector<Tie>& ties() const { return m_ties; }

private:
    /// Where a site lies on the bodies that have entered.
    struct Ends {
        std::int64_t first = -1;  ///< BodyId; -1: not there
        std::int64_t second = -1;
        Vec3 onFirst = Vec3::Zero();
        Vec3 onSecond = Vec3::Zero();

        void keep(Archive& archive) { archive(first, second, onFirst, onSecond); }
    };
    struct Taut;
    void form(const TieSite& site, const Ends& ends, const RigidWorld& world);
    bool stretch(Tie& tie, std::size_t index, const SubstepBodies& bodies, double h);
    /// m/s, by how much it changed the opening speed.
    double pull(Taut& taut);

    const RunDescription& m_description;
    RigidWorld& m_world;
    double m_strength;
    double m_ratio;
    double m_elongation;
    double m_gravity;
    std::vector<TieSite> m_sites;
    std::vector<Ends> m_ends;                           ///< [sites]
    std::vector<std::vector<std::uint32_t>> m_sitesOf;  ///< [clusters]
    std::vector<Tie> m_ties;
    std::vector<Taut> m_taut;
    std::vector<BodyId> m_wake;
    std::int64_t m_broken = 0;
    double m_work = 0.0;
};

}  // namespace rubble
