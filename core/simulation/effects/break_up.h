#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/effects/effect.h"

namespace rubble {

/// A cluster of stone or masonry without reinforcement that is hit hard falls apart into its fragments: when the velocity of its
/// centre of mass changes within two steps by more than a threshold, beyond what gravity and the other effects did to it, that is,
/// when contacts gave it an impulse per mass above the threshold. One body for each fragment takes its place, at the same place and
/// with the velocities of the rigid motion after the hit: mass, momentum, angular momentum and kinetic energy are those of the
/// cluster.
///
/// The threshold (break_up_speed, 6 m/s: a fall of 1.8 m) is an assumption and reported as one: what a bond of mortar or a flaw in
/// a block bears on impact is known for no collapse in advance. Its influence on the debris can be measured.
///
/// Limits: all or nothing, along element faces; no energy is spent on breaking; a hit that takes longer than two steps counts by
/// its hardest two (a soft contact may begin at the end of one step and end in the next); a cluster holds together where its
/// fragments would bring the bodies present above bodies_max (counted).
class BreakUp : public Effect {
public:
    explicit BreakUp(const RunDescription& description);

    EffectKind kind() const override { return EffectKind::BreakUp; }
    void entered(std::span<const BodyRecord> bodies, RigidWorld& world) override;
    void leaving(BodyId body) override;
    std::int64_t events() const override { return m_broken; }
    void keep(Archive& archive) override;

    /// The other effects changed the velocity of a body by this much in the coming step [m/s].
    void excuse(BodyId body, const Vec3& change);
    /// The bodies that fall apart for what the step of dt [s] that has just ended did to them, in the order of their ids.
    /// @param room  bodies that may come on top of those present; it shrinks
    std::vector<BodyRecord> brokenBy(const RigidWorld& world, double dt, std::int64_t& room);
    /// A cluster has been replaced.
    void broken() { ++m_broken; }
    /// Clusters that were hit hard enough and held together for want of room or a sound body.
    std::int64_t held() const { return m_held; }
    void hold() { ++m_held; }

private:
    struct Candidate {
        BodyRecord record;
        std::int64_t more = 0;         ///< bodies that its breaking up adds
        Vec3 velocity = Vec3::Zero();  ///< m/s, before the step
        Vec3 change = Vec3::Zero();    ///< m/s, by contacts in the step before
        Vec3 excused = Vec3::Zero();

        void keep(Archive& archive);
    };
    const RunDescription& m_description;
    double m_threshold;
    double m_gravity;
    std::vector<Candidate> m_candidates;      ///< in the order of their bodies
    std::vector<std::int32_t> m_candidateOf;  ///< [bodies], -1: none
    std::int64_t m_broken = 0;
    std::int64_t m_held = 0;
};

/// A fragment of a cluster as a body of its own.
struct FreedFragment {
    NewBody body;
    FragmentId fragment{};
    Pose toBody;  ///< of the fragment at hand-over into the frame of the new body
};

/// The fragments of a cluster as bodies of their own, in their order, where the body of the cluster is now and moving with it.
/// Nothing if one of them cannot be a body.
/// @param record   of the body that carries them, from its hand-over
/// @param carried  its fragments
std::optional<std::vector<FreedFragment>> freeFragments(const RunDescription& description, const BodyRecord& record,
                                                        std::span<const Carrier> carried, const BodyMotion& motion);

}  // namespace rubble
