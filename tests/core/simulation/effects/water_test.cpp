#include "core/simulation/effects/water.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

/// Water with its surface at zero, without ground.
class InWater : public testing::Test {
protected:
    test::WorldScene scene;
    EffectSettings settings;
    std::unique_ptr<Water> water;

    void SetUp() override {
        scene.settings.ground = false;
        scene.settings.freeze = false;
        settings.waterLevel = 0.0;
    }
    BodyId body(const Vec3& centre, const Vec3& size, double density, const Vec3& velocity = Vec3::Zero(),
                const Quat& turn = Quat::Identity()) {
        NewBody made = test::boxBody(centre, size, velocity, turn);
        made.inertia *= density / 2400.0;
        made.mass = density * size.prod();
        made.volume = size.prod();
        return scene.world().addBody(made);
    }
    void fill() {
        water = std::make_unique<Water>(settings, scene.settings.gravity);
        scene.world().onSubstep([this](const SubstepBodies& bodies, double h) { water->beforeSubstep(bodies, h); });
    }
    double tilt(BodyId id) {
        return std::acos(std::clamp((scene.world().motion(id).pose.orientation * Vec3::UnitZ()).z(), -1.0, 1.0));
    }
};

TEST_F(InWater, AStoneSinksAtItsTerminalSpeed) {
    fill();
    const BodyId stone = body({0, 0, -1}, {0.3, 0.3, 0.3}, 2400.0);
    scene.run(5.0);
    // (m - rho V) g = 1/2 rho C_d A v^2 + c rho V v.
    const double a = 0.5 * 1000.0 * settings.waterDrag * 0.09, b = settings.waterLinearDrag * 27.0,
                 c = -(2400.0 - 1000.0) * 0.027 * standardGravity;
    const double terminal = (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
    EXPECT_NEAR(terminal, 2.66, 0.01);  // without drag near rest 2.80, as PHYSICS section 5 quotes
    const double from = scene.place(stone).z();
    scene.run(1.0);
    // Implicit with gravity in the balance: the fixed point is exact.
    EXPECT_NEAR(from - scene.place(stone).z(), terminal, 1e-6 * terminal);
    // The world reports the velocity after gravity's kick in a substep; at most half of a step's lies ahead of the way.
    EXPECT_NEAR(-scene.velocity(stone).z(), terminal, 0.5 * standardGravity * scene.dt + 1e-6);
}

TEST_F(InWater, ApproachesItAsTheAddedMassSays) {
    settings.waterLinearDrag = 0.0;
    fill();
    const BodyId stone = body({0, 0, -1}, {0.3, 0.3, 0.3}, 2400.0);
    const double weight = (2400.0 - 1000.0) * 0.027 * standardGravity;
    const double terminal = std::sqrt(weight / (0.5 * 1000.0 * settings.waterDrag * 0.09));
    EXPECT_NEAR(terminal, 2.80, 0.01);
    const double inert = (2400.0 + settings.addedMass * 1000.0) * 0.027;
    const double scale = inert * terminal / weight;
    scene.dt = 1.0 / 240.0;
    for (int i = 1; i <= 4; ++i) {
        scene.run(0.25);
        const double time = 0.25 * i;
        // v = v_t tanh(t / scale); first order in the step, 0.9 % of the scale. Half of gravity's last kick lies ahead.
        EXPECT_NEAR(-scene.velocity(stone).z() - 0.5 * standardGravity * scene.dt, terminal * std::tanh(time / scale),
                    0.009 * terminal)
            << time;
    }
}

TEST_F(InWater, ABlockOfHalfTheDensityFloatsAtHalfItsHeight) {
    fill();
    const BodyId raft = body({0, 0, 0.4}, {2, 2, 0.5}, 500.0);
    scene.run(60.0);
    EXPECT_NEAR(scene.place(raft).z(), 0.0, 1e-4) << "0.25 m under, 0.25 m above";
    EXPECT_LT(scene.velocity(raft).norm(), 0.5 * standardGravity * scene.dt + 1e-4) << "after gravity's kick";
    EXPECT_LT(tilt(raft), 1e-6);
}

TEST_F(InWater, DraughtIsTheRatioOfDensities) {
    fill();
    std::vector<BodyId> rafts;
    const std::vector<double> densities{200.0, 600.0, 900.0};
    for (std::size_t i = 0; i < densities.size(); ++i) {
        rafts.push_back(body({10.0 * static_cast<double>(i), 0, 0.1}, {3, 2, 0.4}, densities[i]));
    }
    scene.run(60.0);
    for (std::size_t i = 0; i < densities.size(); ++i) {
        const double draught = 0.2 - scene.place(rafts[i]).z();
        EXPECT_NEAR(draught, 0.4 * densities[i] / 1000.0, 1e-4) << densities[i];
    }
}

TEST_F(InWater, OnlyMaterialDisplaces) {
    fill();
    // Half of the box is voids: it floats like a box of twice the density.
    NewBody loose = test::boxBody({0, 0, 0}, {2, 2, 0.5});
    loose.mass = 2.0 * 250.0;
    loose.inertia *= loose.mass / (2400.0 * 2.0);
    loose.volume = 1.0;
    const BodyId id = scene.world().addBody(loose);
    scene.run(60.0);
    EXPECT_NEAR(0.25 - scene.place(id).z(), 0.25, 1e-4);
}

TEST_F(InWater, HeavesAtItsNaturalPeriod) {
    settings.waterDrag = 0.0;
    settings.waterLinearDrag = 0.0;
    scene.dt = 1.0 / 240.0;
    fill();
    const BodyId raft = body({0, 0, 0.02}, {2, 2, 0.5}, 500.0);
    int crossings = 0;
    double last = 1.0, first = 0.0, latest = 0.0, time = 0.0;
    scene.run(20.0, [&](double) {
        const double z = scene.place(raft).z();
        if (last > 0.0 && z <= 0.0) {
            latest = time;
            if (crossings++ == 0) {
                first = time;
            }
        }
        last = z;
        time += scene.dt;
    });
    ASSERT_GT(crossings, 5);
    // Added mass at the mean draught; it changes by 8 % over the amplitude, to first order on both sides alike.
    const double inert = 1000.0 + settings.addedMass * 1000.0;
    const double period = 2.0 * std::numbers::pi * std::sqrt(inert / (1000.0 * standardGravity * 4.0));
    EXPECT_NEAR((latest - first) / (crossings - 1), period, 0.02 * period);
}

TEST_F(InWater, ATiltedRaftRightsItself) {
    fill();
    const BodyId raft =
        body({0, 0, 0}, {2, 2, 0.5}, 500.0, Vec3::Zero(), Quat(Eigen::AngleAxisd(0.35, Vec3(1, 0.4, 0).normalized())));
    scene.run(60.0);
    EXPECT_LT(tilt(raft), 0.02);
    EXPECT_NEAR(scene.place(raft).z(), 0.0, 1e-3);
}

TEST_F(InWater, ACubeOfHalfTheDensityDoesNotFloatFlat) {
    fill();
    // Metacentre below the centre of mass: b^2 / (12 T) = 0.167 < T / 2 = 0.25.
    const BodyId cube = body({0, 0, 0}, {1, 1, 1}, 500.0, Vec3::Zero(), Quat(Eigen::AngleAxisd(0.02, Vec3::UnitX())));
    scene.run(40.0);
    EXPECT_NEAR(tilt(cube), 0.25 * std::numbers::pi, 0.05);
}

TEST_F(InWater, TheCurrentCarriesWhatFloats) {
    settings.currentX = 1.5;
    settings.currentY = -0.5;
    fill();
    const BodyId raft = body({0, 0, 0}, {2, 2, 0.5}, 500.0);
    scene.run(60.0);
    EXPECT_NEAR(scene.velocity(raft).x(), 1.5, 1e-3);
    EXPECT_NEAR(scene.velocity(raft).y(), -0.5, 1e-3);
}

TEST_F(InWater, BooksExactlyWhatItDoes) {
    settings.currentX = 1.0;
    fill();
    body({0, 0, 3}, {0.6, 0.4, 0.3}, 700.0, {2, 0, -3}, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())));
    const double before = scene.energy();
    scene.run(6.0);
    // Gravity's work is exact, so what is left over is the second order of the spin integration (PHYSICS section 4: 1 %).
    EXPECT_NEAR(scene.energy(), before + water->work(), 1e-3 * before);
}

/// A body on a floor that gives what it takes to stop it, without an engine.
TEST(WaterContact, ABodyAtRestPressesOnTheBedWithItsWeightUnderWater) {
    EffectSettings settings;
    settings.waterLevel = 10.0;
    for (const double added : {0.0, 0.5, 5.0}) {
        settings.addedMass = added;
        Water water(settings, standardGravity);
        MovingBody body;
        body.inverseMass = 1.0 / 2400.0;
        body.volume = 1.0;
        body.inertia = Vec3::Constant(400.0);
        body.inverseInertia = Mat3::Identity() / 400.0;
        body.box.halfExtents = Vec3::Constant(0.5);
        const std::vector<std::int32_t> slots{0};
        const double h = 1.0 / 240.0;
        double pressed = 0.0;
        for (int i = 0; i < 200; ++i) {
            water.beforeSubstep({{&body, 1}, slots}, h);
            body.velocity.z() -= standardGravity * h;
            pressed = std::max(0.0, -body.velocity.z()) / body.inverseMass / h;
            body.velocity.z() = std::max(0.0, body.velocity.z());
        }
        // The share that is still missing falls by m_a / (m + m_a) a substep: 0.68^200 at most.
        EXPECT_NEAR(pressed, 1400.0 * standardGravity, 1e-6 * 1400.0 * standardGravity) << added;
    }
}

TEST(WaterContact, ABlowTakesTheMomentumOfTheAddedMassToo) {
    EffectSettings settings;
    settings.waterLevel = 10.0;
    settings.waterDrag = settings.waterLinearDrag = 0.0;
    Water water(settings, 0.0);
    MovingBody body;
    body.inverseMass = 1.0 / 1000.0;
    body.volume = 1.0;
    body.inertia = Vec3::Constant(400.0);
    body.inverseInertia = Mat3::Identity() / 400.0;
    body.box.halfExtents = Vec3::Constant(0.5);
    body.velocity.x() = -2.0;
    const std::vector<std::int32_t> slots{0};
    double impulse = 0.0;
    for (int i = 0; i < 100; ++i) {
        water.beforeSubstep({{&body, 1}, slots}, 1.0 / 240.0);
        if (i >= 3) {
            impulse += std::max(0.0, -body.velocity.x()) / body.inverseMass;
            body.velocity.x() = std::max(0.0, body.velocity.x());
        }
    }
    // (m + C_a rho V) v; the rest is 0.33^97.
    EXPECT_NEAR(impulse, (1000.0 + 500.0) * 2.0, 1e-6 * 3000.0);
}

TEST_F(InWater, StaysFiniteAtAnyStep) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const double step : {1.0 / 60.0, 0.1, 0.5, 2.0}) {
        test::WorldScene own;
        own.settings = scene.settings;
        own.dt = step;
        EffectSettings rough = settings;
        Water sea(rough, standardGravity);
        own.world().onSubstep([&](const SubstepBodies& bodies, double h) { sea.beforeSubstep(bodies, h); });
        for (int i = 0; i < 30; ++i) {
            const Vec3 size(0.01 + 2.0 * share(random), 0.01 + 2.0 * share(random), 0.01 + 0.3 * share(random));
            NewBody made = test::boxBody({10.0 * i, 0, share(random)}, size, {0, 0, -5.0 * share(random)},
                                         Quat(Eigen::AngleAxisd(share(random), Vec3::UnitX())));
            const double density = 15.0 + 1500.0 * share(random);
            made.mass *= density / 2400.0;
            made.inertia *= density / 2400.0;
            made.volume = size.prod();
            own.world().addBody(made);
        }
        own.run(200.0 * step);
        for (std::size_t i = 0; i < own.world().bodyCount(); ++i) {
            const Vec3 velocity = own.velocity(idAt<BodyId>(i));
            ASSERT_TRUE(velocity.allFinite()) << step;
            // Slower than what falls in from a metre, and than two steps of gravity: at 2 s a raft may leap, but no further.
            EXPECT_LT(velocity.norm(), 8.0 + 2.0 * standardGravity * step) << step << " " << i;
        }
    }
}

}  // namespace
}  // namespace rubble
