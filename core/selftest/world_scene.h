#pragma once

#include <cmath>
#include <memory>

#include "core/base/execution.h"
#include "core/engine/world/rigid_world.h"
#include "core/selftest/hard_case.h"

namespace rubble::selftest {

/// A world with boxes: the few lines that every physical case begins with.
class WorldScene {
public:
    WorldScene() = default;
    explicit WorldScene(const CaseSetting& setting)
        : solver(setting.solver), execution(setting.execution), hashes(setting.hashes) {}

    /// Settings are read when the first body or piece enters.
    WorldSettings settings;
    SolverKind solver = SolverKind::Bullet;
    double dt = 1.0 / 60.0;                    ///< s
    Execution execution;                       ///< run() throws Cancelled once it is cancelled
    std::shared_ptr<TrajectoryHashes> hashes;  ///< of what moves here, if asked for

    RigidWorld& world();
    /// A solid box of 2,400 kg/m3.
    BodyId box(const Vec3& centre, const Vec3& size, const Vec3& velocity = Vec3::Zero(), const Quat& turn = Quat::Identity(),
               const Vec3& spin = Vec3::Zero());
    PieceId piece(const Vec3& centre, const Vec3& size, const Quat& turn = Quat::Identity());
    /// Runs for a time; `before` is called before each step with the time at its end.
    template <class Before>
    void run(double seconds, Before before) {
        const auto steps = static_cast<int>(std::lround(seconds / dt));
        for (int i = 0; i < steps; ++i) {
            m_time += dt;
            before(m_time);
            world().step(dt);
            execution.check();
        }
    }
    void run(double seconds) {
        run(seconds, [](double) {});
    }
    double time() const { return m_time; }

    std::size_t bodies() { return world().bodyCount(); }
    Vec3 place(BodyId body) { return world().motion(body).pose.position; }
    Vec3 velocity(BodyId body) { return world().motion(body).velocity; }
    /// J, kinetic and potential above zero, of all bodies present.
    double energy();
    /// m/s, of the fastest body; NaN as soon as one is not a number.
    double maxSpeed();
    /// Share of the bodies present that sleep.
    double asleep();

private:
    std::unique_ptr<RigidWorld> m_world;
    double m_time = 0.0;
};

NewBody boxBody(const Vec3& centre, const Vec3& size, const Vec3& velocity = Vec3::Zero(), const Quat& turn = Quat::Identity(),
                const Vec3& spin = Vec3::Zero(), double density = 2400.0);
CollisionShape boxShape(const Vec3& size);

/// Watches the mechanical energy of a scene: what it gains beyond the work that the world booked for pieces and for overlap.
class EnergyWatch {
public:
    /// Call after each step, and once before the first.
    void look(WorldScene& scene);
    /// Bodies have entered: call right after, before the next step.
    void admit(WorldScene& scene);
    /// Largest rise so far above what the energy had been before, J.
    double gain() const { return m_gain; }
    /// The same over what gravity and the first kinetic energy have put to use so far; 0 where nothing moved.
    double drift() const { return m_most > 0.0 ? m_gain / m_most : 0.0; }

private:
    struct Energies {
        double kinetic = 0.0;
        double potential = 0.0;
        double booked = 0.0;
        double own() const { return kinetic + potential - booked; }
    };
    static Energies energiesOf(WorldScene& scene);

    bool m_started = false;
    Energies m_last;
    double m_firstPotential = 0.0;
    double m_firstKinetic = 0.0;
    double m_least = 0.0;
    double m_gain = 0.0;
    double m_most = 0.0;
};

}  // namespace rubble::selftest
