#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/base/standard_gravity.h"
#include "tests/core/simulation/world_scene.h"

namespace rubble::test {
namespace {

std::shared_ptr<const TerrainGrid> terrainOf(const std::function<double(double, double)>& height, double cell = 2.0,
                                             double reach = 40.0) {
    const auto count = static_cast<std::size_t>(2.0 * reach / cell) + 1;
    std::vector<double> heights;
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t i = 0; i < count; ++i) {
            heights.push_back(height(-reach + cell * static_cast<double>(i), -reach + cell * static_cast<double>(j)));
        }
    }
    return std::make_shared<const TerrainGrid>(-reach, -reach, cell, count, count, heights);
}

class TerrainContact : public testing::TestWithParam<SolverKind> {
protected:
    TerrainContact() {
        scene.solver = GetParam();
        scene.settings.reach = Aabb(Vec3(-10.0, -10.0, 0.0), Vec3(10.0, 10.0, 10.0));
        scene.settings.groundHeight = 100.0;  // would show at once if the level ground took part
    }
    void stand(const std::function<double(double, double)>& height) { scene.settings.terrain = terrainOf(height); }
    double depth(BodyId body) {
        const Vec3 p = scene.place(body);
        return scene.settings.terrain->height(p.x(), p.y()) - p.z();
    }

    WorldScene scene;
};

TEST_P(TerrainContact, ABoxRestsOnALevelTerrain) {
    stand([](double, double) { return -3.0; });
    const BodyId box = scene.box(Vec3(0.3, 0.2, -2.0), Vec3(1.0, 1.0, 1.0));
    scene.run(3.0);
    // Contacts may overlap by a few millimetres.
    EXPECT_NEAR(scene.place(box).z(), -2.5, 0.01);
    EXPECT_LT(scene.velocity(box).norm(), 0.02);
}

TEST_P(TerrainContact, BeyondTheEdgeItRestsOnTheLevelThatGoesOn) {
    stand([](double x, double) { return 0.1 * x; });
    scene.settings.reach.extend(Vec3(80.0, 0.0, 0.0));
    const BodyId box = scene.box(Vec3(60.0, 0.0, 5.0), Vec3(1.0, 1.0, 1.0));
    scene.run(3.0);
    EXPECT_NEAR(scene.place(box).z(), 4.5, 0.01);
}

TEST_P(TerrainContact, ASlopeHoldsOrSlidesAsCoulombSays) {
    for (const double degrees : {20.0, 35.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        WorldScene slope;
        slope.solver = GetParam();
        slope.settings.pairs = PairTable::uniform(0.5, 0.0);
        slope.settings.terrain = terrainOf([angle](double x, double) { return -std::tan(angle) * x; });
        const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitY()));
        const Vec3 up = turn * Vec3::UnitZ();
        const BodyId box = slope.box(0.5 * up, Vec3(2.0, 2.0, 1.0), Vec3::Zero(), turn);
        slope.run(0.25);  // contact settles
        const Vec3 from = slope.place(box);
        const double speed = slope.velocity(box).norm();
        slope.run(1.0);
        const double way = (slope.place(box) - from).norm();
        if (degrees < 30.0) {
            // The stock solver creeps (PHYSICS.md section 4).
            EXPECT_LT(way, GetParam() == SolverKind::Bullet ? 0.1 : 0.001) << degrees;
        } else {
            const double expected = speed + 0.5 * standardGravity * (std::sin(angle) - 0.5 * std::cos(angle));
            EXPECT_NEAR(way, expected, 0.08 * expected) << degrees;
        }
    }
}

TEST_P(TerrainContact, NothingIsBelowTheSurfaceOfAValley) {
    stand([](double x, double y) { return 0.02 * x * x + 0.3 * std::sin(y); });
    std::mt19937 random(5);
    std::uniform_real_distribution place(-12.0, 12.0);
    std::uniform_real_distribution size(0.2, 1.0);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) {
        bodies.push_back(scene.box(Vec3(place(random), place(random), 6.0 + 0.1 * i),
                                   Vec3(size(random), size(random), size(random)), Vec3(place(random) / 3.0, 0.0, -5.0)));
    }
    for (int s = 0; s < 8; ++s) {
        scene.run(0.5);
        for (const BodyId body : bodies) {
            ASSERT_LE(depth(body), 1e-9) << "body " << at(body) << " at " << scene.place(body).transpose();
        }
    }
    EXPECT_LT(scene.maxSpeed(), 5.0);
}

TEST_P(TerrainContact, AFastBoxDoesNotPassThrough) {
    stand([](double x, double y) { return 0.2 * std::sin(0.7 * x) + 0.2 * std::cos(0.5 * y); });
    for (const double speed : {15.0, 30.0, 100.0}) {
        const BodyId box = scene.box(Vec3(-10.0 + 0.2 * speed, 3.0, 2.0), Vec3(0.05, 0.05, 0.05), Vec3(0.3 * speed, 0.0, -speed));
        scene.run(0.5);
        EXPECT_LE(depth(box), 1e-9) << speed;
    }
}

TEST_P(TerrainContact, TheSameSceneGivesTheSameBits) {
    const auto outcome = [] {
        WorldScene again;
        again.solver = GetParam();
        again.settings.terrain = terrainOf([](double x, double y) { return 0.02 * x * x + 0.01 * y * y; });
        for (int i = 0; i < 20; ++i) {
            again.box(Vec3(0.7 * i - 7.0, 0.3 * (i % 3), 3.0), Vec3(0.5, 0.4, 0.3));
        }
        again.run(1.0);
        std::vector<Vec3> places;
        for (int i = 0; i < 20; ++i) {
            places.push_back(again.place(idAt<BodyId>(static_cast<std::size_t>(i))));
        }
        return places;
    };
    EXPECT_EQ(outcome(), outcome());
}

INSTANTIATE_TEST_SUITE_P(Solvers, TerrainContact, testing::Values(SolverKind::Bullet, SolverKind::SoftStep),
                         [](const auto& solver) { return solver.param == SolverKind::Bullet ? "Bullet" : "SoftStep"; });

}  // namespace
}  // namespace rubble::test
