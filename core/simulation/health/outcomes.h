#pragma once

#include <vector>

#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// A body on its way, from its entry to the latest step.
struct TrackedBody {
    std::uint32_t firstCarrier = 0;
    std::uint32_t carriers = 0;
    double birthEnergy = 0.0;  ///< J/kg, kinetic, spin included: a span that turns about its foot makes speed of it
    double birthHeight = 0.0;  ///< m
    double mass = 0.0;         ///< kg
    double kinetic = 0.0;      ///< J, spin included
    double hardest = 0.0;      ///< m/s, change of velocity in the hardest hit; 0: nothing has hit it
    BodyMotion before;         ///< just before it
    BodyMotion latest;         ///< numbers always; of a lost or removed body where it was last
    bool lost = false;         ///< its place or velocity is no number any more
};

/// Follows every body from step to step and knows at the end where each fragment went, how fast it was born and how hard it hit.
class Outcomes {
public:
    Outcomes(const RunDescription& description, double gravity);

    /// Bodies have entered, at a hand-over or in the place of one that broke up: then the fragments change over to them.
    void entered(const HandOver& handOver, const RigidWorld& world);
    /// Takes note of one step that ended at `time`.
    void stepped(const RigidWorld& world, double time, double dt);
    /// Settles the final places; bodies that left keep where they were last.
    void finish(const RigidWorld& world);

    /// In the order in which they came; those whose body is still there carry what there is.
    const std::vector<Carrier>& carriers() const { return m_carriers; }
    const std::vector<FragmentOutcome>& fragments() const { return m_fragments; }
    double maxSpeed() const { return m_maxSpeed; }
    /// J, of all bodies present after the latest step.
    double kineticEnergy() const { return m_kinetic; }
    /// kg m, of all bodies present after the latest step: mass times height above zero.
    double massHeight() const { return m_massHeight; }
    /// [bodies that ever entered]
    const std::vector<TrackedBody>& bodies() const { return m_bodies; }
    /// Bodies that became no number in the latest step: to be taken out of the world before the next.
    const std::vector<BodyId>& lost() const { return m_lost; }
    void keep(Archive& archive);

private:
    struct Pending {
        double time = 0.0;
        std::uint32_t carrier = 0;

        void keep(Archive& archive);
    };
    /// What one step did to a body; false: it is not there any more. Bodies may be followed at once.
    /// @param fall  m/s, by which gravity alone has changed its velocity
    bool follow(const RigidWorld& world, std::size_t i, const Vec3& fall);
    /// Notes a carrier; a fragment that is not born yet is born from its latest one.
    void carry(const Carrier& carrier);
    Vec3 placeOf(const Carrier& carrier, const Pose& body) const;

    const RunDescription& m_description;
    double m_gravity;
    std::vector<FragmentOutcome> m_fragments;
    std::vector<Carrier> m_carriers;
    std::vector<bool> m_carried;  ///< [fragments]
    std::vector<TrackedBody> m_bodies;
    std::vector<BodyId> m_lost;
    std::vector<Pending> m_pending;  ///< fragments handed over and not yet born
    double m_maxSpeed = 0.0;
    double m_kinetic = 0.0;
    double m_massHeight = 0.0;
};

}  // namespace rubble
