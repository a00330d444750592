#pragma once

#include <memory>

#include "core/simulation/rigid_world.h"

namespace rubble::test {

/// A world with boxes: the few lines that every physics test begins with.
class WorldScene {
public:
    /// Settings are read when the first body or piece enters.
    WorldSettings settings;
    double dt = 1.0 / 60.0;  ///< s

    RigidWorld& world();
    /// A solid box of 2,400 kg/m3.
    BodyId box(const Vec3& centre, const Vec3& size, const Vec3& velocity = Vec3::Zero(), const Quat& turn = Quat::Identity(),
               const Vec3& spin = Vec3::Zero());
    PieceId piece(const Vec3& centre, const Vec3& size, const Quat& turn = Quat::Identity());
    /// Runs for a time; `before` is called before each step with the time at its end.
    template <class Before>
    void run(double seconds, Before before) {
        const auto steps = static_cast<int>(seconds / dt + 0.5);
        for (int i = 0; i < steps; ++i) {
            m_time += dt;
            before(m_time);
            world().step(dt);
        }
    }
    void run(double seconds) {
        run(seconds, [](double) {});
    }

    Vec3 place(BodyId body) { return world().motion(body).pose.position; }
    Vec3 velocity(BodyId body) { return world().motion(body).velocity; }
    /// J, kinetic and potential above zero, of all bodies.
    double energy();
    double maxSpeed();

private:
    std::unique_ptr<RigidWorld> m_world;
    double m_time = 0.0;
};

NewBody boxBody(const Vec3& centre, const Vec3& size, const Vec3& velocity = Vec3::Zero(), const Quat& turn = Quat::Identity(),
                const Vec3& spin = Vec3::Zero());
CollisionShape boxShape(const Vec3& size);

}  // namespace rubble::test
