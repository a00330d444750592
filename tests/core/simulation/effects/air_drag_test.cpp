#include "core/simulation/effects/air_drag.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

/// A world in air, without ground.
class InAir : public testing::Test {
protected:
    test::WorldScene scene;
    EffectSettings settings;
    std::unique_ptr<AirDrag> drag;

    void SetUp() override {
        scene.settings.ground = false;
        scene.settings.freeze = false;
        drag = std::make_unique<AirDrag>(settings);
        scene.world().onSubstep([this](const SubstepBodies& bodies, double h) { drag->beforeSubstep(bodies, h); });
    }
    /// kg/m of the drag on an area.
    double resistance(double area) const { return 0.5 * settings.airDensity * settings.airDrag * area; }
};

TEST_F(InAir, APlateReachesItsTerminalSpeedAsTheLawSays) {
    // 1 m x 1 m x 2 cm of 2,400 kg/m3, face on.
    const BodyId plate = scene.box({0, 0, 1000}, {1, 1, 0.02});
    const double mass = scene.world().mass(plate);
    const double terminal = std::sqrt(mass * standardGravity / resistance(1.0));
    EXPECT_NEAR(terminal, 27.05, 0.01);
    for (const double time : {1.0, 2.0, 4.0}) {
        scene.run(time - (time > 1.0 ? time / 2.0 : 0.0));
        // v = v_t tanh(g t / v_t), z = v_t^2 / g ln cosh(g t / v_t).
        const double fallen = terminal * terminal / standardGravity * std::log(std::cosh(standardGravity * time / terminal));
        // Drag and gravity act one after the other, so that the speed at the end of a step is half a kick (g dt / 2 = 0.08 m/s)
        // ahead once they balance; the way is right to second order.
        EXPECT_NEAR(-scene.velocity(plate).z(), terminal * std::tanh(standardGravity * time / terminal),
                    0.5 * standardGravity * scene.dt + 0.01)
            << time;
        EXPECT_NEAR(1000.0 - scene.place(plate).z(), fallen, 2e-3 * fallen) << time;
    }
    scene.run(16.0);
    const double before = scene.place(plate).z();
    scene.run(1.0);
    EXPECT_NEAR(before - scene.place(plate).z(), terminal, 2e-3 * terminal);
}

TEST_F(InAir, AStoneBlockOf03mHasATerminalSpeedOf106) {
    // PHYSICS section 5 quotes 106 m/s.
    const double mass = 2400.0 * 0.027;
    EXPECT_NEAR(std::sqrt(mass * standardGravity / resistance(0.09)), 106.0, 1.5);
    // Edge on the area grows by sqrt 2, so that the drag at a speed does.
    const Quat edge(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()));
    const BodyId flat = scene.box({0, 0, 0}, {0.3, 0.3, 0.3}, {0, 0, -50});
    const BodyId turned = scene.box({5, 0, 0}, {0.3, 0.3, 0.3}, {0, 0, -50}, edge);
    scene.run(scene.dt);
    const double fall = standardGravity * scene.dt;
    EXPECT_NEAR((scene.velocity(turned).z() + 50.0 + fall) / (scene.velocity(flat).z() + 50.0 + fall), std::numbers::sqrt2, 2e-3);
}

/// Way of a body under gravity and quadratic drag by the classical Runge-Kutta method with small steps.
Vec3 integrate(Vec3 velocity, double perMass, double time) {
    Vec3 place = Vec3::Zero();
    const auto acceleration = [&](const Vec3& v) { return Vec3(Vec3(0, 0, -standardGravity) - perMass * v.norm() * v); };
    const int steps = 20000;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Vec3 a = acceleration(velocity), b = acceleration(velocity + 0.5 * h * a), c = acceleration(velocity + 0.5 * h * b),
                   d = acceleration(velocity + h * c);
        place += h * velocity + h * h / 6.0 * (a + b + c);
        velocity += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return place;
}

TEST_F(InAir, AProjectileFollowsTheDifferentialEquation) {
    // A board of light timber, so that drag takes a third of the way; its area is that of the velocity's direction at each instant,
    // so a cube is thrown along the diagonal of its faces and compared while the direction stays within what changes it little.
    NewBody body = test::boxBody({0, 0, 0}, {0.2, 0.2, 0.2}, {30, 0, 0});
    body.mass *= 0.02;
    body.inertia *= 0.02;
    const BodyId id = scene.world().addBody(body);
    const double time = 0.5;
    scene.run(time);
    // |n . v| summed over the axes of a cube is |v_x| + |v_z| over |v|: the exact law along the way.
    Vec3 place = Vec3::Zero(), velocity(30, 0, 0);
    const int steps = 50000;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const auto acceleration = [&](const Vec3& v) {
            const double area = 0.04 * (std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z())) / v.norm();
            return Vec3(Vec3(0, 0, -standardGravity) - resistance(area) / body.mass * v.norm() * v);
        };
        const Vec3 middle = velocity + 0.5 * h * acceleration(velocity);
        place += h * middle;
        velocity += h * acceleration(middle);
    }
    const Vec3 free(30 * time, 0, -0.5 * standardGravity * time * time);
    EXPECT_GT((free - place).norm(), 0.5) << "drag must matter here";
    // A kick comes before the way of its step: half a step of what drag took, to first order.
    EXPECT_LT((scene.place(id) - place).norm(), 0.6 * scene.dt * (30.0 - velocity.norm()));
    // And with the area held, against the classical method: the two references agree.
    const double held = resistance(0.04) / body.mass;
    EXPECT_LT((integrate({30, 0, 0}, held, time) - place).norm(), 0.1 * place.norm());
}

TEST_F(InAir, BooksExactlyWhatItTakes) {
    const BodyId body =
        scene.box({0, 0, 500}, {0.5, 0.3, 0.1}, {20, 5, -10}, Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized())));
    const double before = scene.energy();
    scene.run(3.0);
    // Gravity's work is exact in free flight, so nothing is left over but rounding.
    EXPECT_NEAR(scene.energy(), before + drag->work(), 1e-9 * before);
    EXPECT_LT(drag->work(), -1000.0);
    EXPECT_GT(scene.velocity(body).norm(), 1.0);
}

TEST_F(InAir, NeverTurnsABodyRoundWhateverTheStep) {
    scene.dt = 2.0;
    NewBody feather = test::boxBody({0, 0, 0}, {1, 1, 0.01}, {400, 0, 0});
    feather.mass *= 1e-3;
    feather.inertia *= 1e-3;
    const BodyId id = scene.world().addBody(feather);
    scene.run(2.0);
    EXPECT_GT(scene.velocity(id).x(), 0.0);
    EXPECT_LT(scene.velocity(id).x(), 400.0);
    EXPECT_LT(drag->work(), 0.0);
}

}  // namespace
}  // namespace rubble
