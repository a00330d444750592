#include "core/fragments/fragment_set.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

using test::ElementScene;
using test::fragmentsOf;

Momenta momentaOf(const Fragment& f) {
    return rigidMomenta(f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity);
}

void expectSound(const FragmentSet& set) {
    ASSERT_EQ(set.vertexOffsets.size(), set.size() + 1);
    ASSERT_EQ(set.solid.size(), set.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Fragment& f = set.list[i];
        EXPECT_GT(f.mass, 0.0);
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(f.inertia).eigenvalues().minCoeff(), 0.0);
        EXPECT_TRUE(f.centre.allFinite() && f.velocity.allFinite() && f.angularVelocity.allFinite());
        EXPECT_GE(f.box.halfExtents.minCoeff(), 0.005 * (1 - 1e-12));
        EXPECT_GE(f.box.halfExtents.minCoeff(), 0.025 * f.box.halfExtents.maxCoeff() * (1 - 1e-9));
        EXPECT_NEAR(f.box.orientation.norm(), 1.0, 1e-12);
        const auto vertices = set.verticesOf(idAt<FragmentId>(i));
        EXPECT_EQ(vertices.size(), static_cast<std::size_t>(cornerCount(set.solid[i])));
        Aabb bounds;
        for (const Vec3& v : vertices) {
            bounds.extend(v);
        }
        EXPECT_TRUE(bounds.isApprox(f.bounds));
        EXPECT_LT(bounds.exteriorDistance(f.centre), 1e-9);
    }
}

void expectClosed(const Fragment& f) {
    const Momenta rigid = momentaOf(f);
    const double linear = f.mass * (1.0 + f.velocity.norm());
    EXPECT_NEAR(rigid.mass, f.fe.mass, 1e-12 * f.mass);
    EXPECT_LT((rigid.linear - f.fe.linear).norm(), 1e-12 * linear);
    EXPECT_LT((rigid.angular - f.fe.angular).norm(), 1e-12 * linear * (1.0 + f.centre.norm()));
    EXPECT_LE(rigid.kineticEnergy, f.fe.kineticEnergy * (1.0 + 1e-12) + 1e-12);
}

/// One dying element of every shape, over and over, moving rigidly about the origin.
ElementScene turningScene(std::mt19937& random, const Vec3& v, const Vec3& w, int rounds, double distortion) {
    ElementScene scene;
    for (int i = 0; i < rounds; ++i) {
        for (const ElementShape shape : test::allShapes) {
            scene.element(shape, test::randomElement(shape, random, 1.0, distortion), "1100",
                          shape == ElementShape::Beam ? 0.04 : 0.2);
        }
    }
    scene.velocity = [=](const Vec3& x, double) { return Vec3(v + w.cross(x)); };
    return scene;
}

TEST(FragmentSet, RigidMotionIsRecoveredForEveryShape) {
    std::mt19937 random(1);
    const Vec3 v(3, -20, 7), w(0.5, -1.5, 0.8);
    const FragmentSet set = fragmentsOf(turningScene(random, v, w, 30, 0.3));
    ASSERT_EQ(set.size(), 30u * std::size(test::allShapes));
    expectSound(set);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Fragment& f = set.list[i];
        EXPECT_LT((f.velocity - v - w.cross(f.centre)).norm(), 1e-11);
        Vec3 spin = w;
        if (test::allShapes[i % std::size(test::allShapes)] == ElementShape::Beam) {
            // The spin about its own axis is not in a beam's nodes.
            const auto x = set.verticesOf(idAt<FragmentId>(i));
            const Vec3 axis = (x[4] - x[0]).normalized();
            spin -= axis * axis.dot(w);
        }
        EXPECT_LT((f.angularVelocity - spin).norm(), 1e-10) << i;
        EXPECT_NEAR(momentaOf(f).kineticEnergy, f.fe.kineticEnergy, 1e-10 * f.fe.kineticEnergy);
        expectClosed(f);
    }
}

TEST(FragmentSet, MomentaCloseForAnyMotionOfAnyShape) {
    std::mt19937 random(2);
    // Distortion up to folding: every element must still close and be sound.
    for (const double distortion : {0.1, 0.5, 1.5, 4.0}) {
        ElementScene scene = turningScene(random, Vec3::Zero(), Vec3::Zero(), 40, distortion);
        scene.velocity = [](const Vec3& x, double) {
            return Vec3(20 * std::sin(9 * x.y()), 15 * std::cos(7 * x.z() + x.x()), 25 * std::sin(11 * x.x()));
        };
        const FragmentSet set = fragmentsOf(scene);
        ASSERT_EQ(set.size(), 40u * std::size(test::allShapes));
        expectSound(set);
        for (const Fragment& f : set.list) {
            expectClosed(f);
        }
    }
}

TEST(FragmentSet, MassIsTheComponentsMassAtRestHoweverDeformed) {
    std::mt19937 random(3);
    ElementScene scene = turningScene(random, Vec3::Zero(), Vec3::Zero(), 5, 0.2);
    scene.position = [](const Vec3& x, double t) { return Vec3(x.cwiseProduct(Vec3(1 + 0.3 * t, 1 - 0.2 * t, 1))); };
    const auto fe = scene.result();
    const Components components = ElementScene::components(*fe);
    const FragmentSet set = makeFragments(*fe, components, {}, Execution());
    for (const Fragment& f : set.list) {
        EXPECT_DOUBLE_EQ(f.mass, components.mass(f.element));
        EXPECT_NEAR(f.fe.mass, f.mass, 1e-13 * f.mass);
    }
}

TEST(FragmentSet, InertiaOfShellAndBeamAreThoseOfTheirBoxes) {
    ElementScene scene;
    scene.element(ElementShape::Quadrilateral, {{0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}}, "10", 0.4, 1000.0);
    scene.element(ElementShape::Beam, {{0, 0, 0}, {4, 0, 0}}, "10", 0.09, 1000.0);
    const FragmentSet set = fragmentsOf(scene);
    const Fragment& slab = set.list[0];
    EXPECT_NEAR(slab.mass, 2400.0, 1e-9);
    EXPECT_LT((slab.inertia - Mat3(Vec3(200.0 * (9 + 0.16), 200.0 * (4 + 0.16), 200.0 * 13).asDiagonal())).norm(), 1e-8);
    EXPECT_LT((slab.box.halfExtents - Vec3(1, 1.5, 0.2)).norm(), 1e-12);
    EXPECT_NEAR(slab.bounds.min().z(), 4.8, 1e-12);
    const Fragment& bar = set.list[1];
    EXPECT_NEAR(bar.mass, 360.0, 1e-9);
    EXPECT_LT((bar.inertia - Mat3(Vec3(30.0 * 0.18, 30.0 * 16.09, 30.0 * 16.09).asDiagonal())).norm(), 1e-8);
    EXPECT_TRUE(bar.bounds.isApprox(Aabb(Vec3(0, -0.15, -0.15), Vec3(4, 0.15, 0.15)), 1e-12));
}

const std::vector<Vec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

std::vector<Vec3> cubeAt(double x) {
    std::vector<Vec3> corners = cube;
    for (Vec3& c : corners) {
        c.x() += x;
    }
    return corners;
}

TEST(FragmentSet, TakesTheLastActiveShapeAndIsBlindAfterDeath) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube, "11100");
    scene.position = [](const Vec3& x, double t) {
        const double c = std::cos(0.3 * t), s = std::sin(0.3 * t);
        return Vec3(c * x.x() - s * x.y() + 5 * t, s * x.x() + c * x.y(), x.z() * (1 - 0.1 * t));
    };
    const FragmentSet set = fragmentsOf(scene);
    scene.damage = [](std::size_t k, FeState& state) {
        if (k > 2) {
            state.positions.assign(8, Vec3::Constant(1e30));
        }
    };
    const FragmentSet damaged = fragmentsOf(scene);
    ASSERT_EQ(set.size(), 1u);
    const Fragment& f = set.list[0];
    EXPECT_EQ(f.handOverState, 2u);
    EXPECT_EQ(f.birthState, 3u);
    EXPECT_EQ(f.handOverTime, 2.0);
    EXPECT_EQ(f.birthTime, 3.0);
    EXPECT_EQ(f.endTime, std::numeric_limits<double>::infinity());
    EXPECT_LT((f.box.halfExtents - Vec3(0.5, 0.5, 0.4)).norm(), 1e-12);
    EXPECT_NEAR(Eigen::AngleAxisd(f.box.orientation).angle(), 0.6, 1e-12);
    EXPECT_EQ(set.vertices, damaged.vertices);
    EXPECT_EQ(f.velocity, damaged.list[0].velocity);
}

TEST(FragmentSet, OrderIsByHandOverThenElementAndStatesAreReadOnceInOrder) {
    ElementScene scene;
    std::mt19937 random(4);
    for (int i = 0; i < 40; ++i) {
        const auto life = 1 + random() % 7;
        scene.element(ElementShape::Hexahedron, cubeAt(2.0 * i), std::string(life, '1') + std::string(8 - life, '0'));
    }
    const FragmentSet set = fragmentsOf(scene);
    ASSERT_EQ(set.size(), 40u);
    for (std::size_t i = 1; i < set.size(); ++i) {
        EXPECT_LT(std::pair(set.list[i - 1].handOverState, set.list[i - 1].element),
                  std::pair(set.list[i].handOverState, set.list[i].element));
    }
    for (std::size_t i = 1; i < scene.reads().size(); ++i) {
        EXPECT_LT(scene.reads()[i - 1], scene.reads()[i]);
    }
}

TEST(FragmentSet, NoDeathsIsAValidAnswer) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube, "1111");
    const FragmentSet set = fragmentsOf(scene);
    EXPECT_EQ(set.size(), 0u);
    EXPECT_EQ(set.vertexOffsets, std::vector<std::uint32_t>{0});
    EXPECT_TRUE(set.findings.empty());
    EXPECT_TRUE(scene.reads().empty());
}

TEST(FragmentSet, FollowEndsAFragmentWhenItsElementReturns) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube, "1101100");
    scene.position = [](const Vec3& x, double t) { return Vec3(x + t * t * Vec3::UnitX()); };
    FragmentSettings settings;
    EXPECT_EQ(fragmentsOf(scene, settings).size(), 1u);
    settings.revival = Revival::Follow;
    const FragmentSet set = fragmentsOf(scene, settings);
    ASSERT_EQ(set.size(), 2u);
    EXPECT_EQ(set.list[0].endTime, 3.0);
    EXPECT_EQ(set.list[1].endTime, std::numeric_limits<double>::infinity());
    EXPECT_EQ(set.list[1].handOverState, 4u);
    // Its second life has two states: a first-order difference, 16 - 9, not one that reaches back over its death.
    EXPECT_NEAR(set.list[1].velocity.x(), 7.0, 1e-12);
    settings.revival = Revival::Refuse;
    EXPECT_THROW(fragmentsOf(scene, settings), UsageError);
}

TEST(FragmentSet, ExactBirthsOnlyBySettingAndOnlyWhereTheyMakeSense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ElementScene scene;
    for (int i = 0; i < 5; ++i) {
        scene.element(ElementShape::Hexahedron, cubeAt(2.0 * i), "1100");
    }
    scene.times = {0.0, 0.1, 0.2, 0.3};
    scene.deathTimes = {0.15, nan, 0.05, 0.2 + 1e-8, 0.1 - 1e-8};
    FragmentSettings settings;
    for (const Fragment& f : fragmentsOf(scene, settings).list) {
        EXPECT_EQ(f.birthTime, 0.2);
    }
    settings.birthTime = BirthTime::Exact;
    const FragmentSet set = fragmentsOf(scene, settings);
    const double expected[]{0.15, 0.2, 0.2, 0.2, 0.1};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(set.list[i].birthTime, expected[i]) << i;
    }
    EXPECT_EQ(set.findings.count("fragments.no_death_time"), 1);
    EXPECT_EQ(set.findings.count("fragments.death_time_outside"), 1);
    scene.deathTimes.clear();
    EXPECT_EQ(fragmentsOf(scene, settings).findings.count("fragments.no_death_time"), 5);
}

TEST(FragmentSet, BornAtRestBySettingWhileTheFileKeepsItsMomenta) {
    std::mt19937 random(5);
    const ElementScene scene = turningScene(random, Vec3(1, 2, 3), Vec3(0, 0, 1), 3, 0.2);
    FragmentSettings settings;
    const FragmentSet moving = fragmentsOf(scene, settings);
    settings.birthVelocity = BirthVelocity::Rest;
    const FragmentSet resting = fragmentsOf(scene, settings);
    for (std::size_t i = 0; i < resting.size(); ++i) {
        EXPECT_TRUE(resting.list[i].velocity.isZero() && resting.list[i].angularVelocity.isZero());
        EXPECT_EQ(resting.list[i].fe.linear, moving.list[i].fe.linear);
        EXPECT_EQ(resting.list[i].fe.angular, moving.list[i].fe.angular);
        EXPECT_EQ(resting.list[i].fe.kineticEnergy, moving.list[i].fe.kineticEnergy);
    }
}

TEST(FragmentSet, BirthShiftMovesEverythingAlikeAndRepeats) {
    std::mt19937 random(6);
    const ElementScene scene = turningScene(random, Vec3(1, 2, 3), Vec3(0, 0, 1), 3, 0.2);
    FragmentSettings settings;
    const FragmentSet still = fragmentsOf(scene, settings);
    settings.birthShift = 1e-3;
    const FragmentSet shifted = fragmentsOf(scene, settings);
    const FragmentSet again = fragmentsOf(scene, settings);
    settings.seed = 2;
    const FragmentSet other = fragmentsOf(scene, settings);
    EXPECT_EQ(shifted.vertices, again.vertices);
    expectSound(shifted);
    for (std::size_t i = 0; i < still.size(); ++i) {
        const Vec3 shift = shifted.list[i].centre - still.list[i].centre;
        EXPECT_NEAR(shift.norm(), 1e-3, 1e-12);
        EXPECT_LT((shifted.list[i].box.centre - still.list[i].box.centre - shift).norm(), 1e-12);
        EXPECT_LT((shifted.list[i].bounds.min() - still.list[i].bounds.min() - shift).norm(), 1e-12);
        EXPECT_LT((shifted.vertices[shifted.vertexOffsets[i]] - still.vertices[still.vertexOffsets[i]] - shift).norm(), 1e-12);
        EXPECT_LT((shifted.list[i].velocity - still.list[i].velocity).norm(), 1e-12);
        EXPECT_GT((other.list[i].centre - shifted.list[i].centre).norm(), 1e-6);
        expectClosed(shifted.list[i]);
    }
}

TEST(FragmentSet, ElementsFarFromTheirVolumeAtRestAreCounted) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cubeAt(0), "10");
    scene.element(ElementShape::Hexahedron, cubeAt(10), "10");  // 2.5 times its volume
    scene.element(ElementShape::Hexahedron, cubeAt(20), "10");  // 0.4 of it
    scene.damage = [](std::size_t, FeState& state) {
        for (std::size_t a = 0; a < 8; ++a) {
            state.positions[a].z() *= 1.9;
            state.positions[8 + a].z() *= 2.5;
            state.positions[16 + a].z() *= 0.4;
        }
    };
    const FragmentSet set = fragmentsOf(scene);
    EXPECT_EQ(set.findings.count("fragments.far_from_rest"), 2);
    EXPECT_DOUBLE_EQ(set.list[1].mass, set.list[0].mass) << "what was meshed falls, however it was stretched";
}

TEST(FragmentSet, SickElementsBecomeSoundAndAreCounted) {
    const auto squeezed = [](double x, double thickness) {
        std::vector<Vec3> corners = cubeAt(x);
        for (Vec3& c : corners) {
            c.z() *= thickness;
        }
        return corners;
    };
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cubeAt(0), "10");   // turned inside out
    scene.element(ElementShape::Hexahedron, cubeAt(10), "10");  // folded
    scene.element(ElementShape::Hexahedron, cubeAt(20), "10");  // flat
    scene.element(ElementShape::Hexahedron, cubeAt(30), "10");  // a point
    scene.element(ElementShape::Hexahedron, squeezed(40, 1e-3), "10");
    scene.element(ElementShape::Hexahedron, squeezed(50, 1e-7), "10");
    scene.element(ElementShape::Hexahedron, std::vector<Vec3>(8, Vec3(60, 0, 0)), "10");  // nothing from the start
    scene.element(ElementShape::Quadrilateral, {cube[0], cube[1], cube[2], cube[3]}, "10", 0.003);
    scene.velocity = [](const Vec3& x, double) { return Vec3(std::sin(5 * x.x()), std::cos(3 * x.y()), 7.0); };
    scene.damage = [](std::size_t, FeState& state) {
        auto& x = state.positions;
        for (std::size_t a = 0; a < 8; ++a) {
            x[a].z() *= -1.0;
            x[24 + a] = Vec3(30, 0, 0);
            x[16 + a].z() = 0.5;
        }
        std::swap(x[12], x[13]);
        std::swap(x[14], x[15]);
    };
    const FragmentSet set = fragmentsOf(scene);
    ASSERT_EQ(set.size(), 8u);
    expectSound(set);
    for (const Fragment& f : set.list) {
        expectClosed(f);
        EXPECT_LT(f.angularVelocity.norm(), 1e3);
    }
    EXPECT_EQ(set.findings.count("fragments.inverted"), 1);
    EXPECT_EQ(set.findings.count("fragments.tangled"), 1);
    EXPECT_EQ(set.findings.count("fragments.collapsed"), 3);
    EXPECT_EQ(set.findings.count("fragments.sliver"), 1);
    EXPECT_EQ(set.findings.count("fragments.thickened"), 2);
    EXPECT_EQ(set.findings.count("fragments.no_volume_at_rest"), 1);
    for (const Finding& finding : set.findings.list()) {
        EXPECT_NE(finding.example.find("element 1,00"), std::string::npos);
        EXPECT_FALSE(finding.remedy.empty());
    }
}

TEST(FragmentSet, DegenerateHexahedraAreOrdinaryElements) {
    // A wedge and a tetrahedron written as hexahedra with repeated nodes.
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, {cube[0], cube[1], cube[3], cube[3], cube[4], cube[5], cube[7], cube[7]}, "10");
    scene.element(ElementShape::Wedge, {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]}, "10");
    scene.element(ElementShape::Hexahedron, {cube[0], cube[1], cube[3], cube[3], cube[4], cube[4], cube[4], cube[4]}, "10");
    scene.element(ElementShape::Tetrahedron, {cube[0], cube[1], cube[3], cube[4]}, "10");
    const FragmentSet set = fragmentsOf(scene);
    for (std::size_t i = 0; i < 4; i += 2) {
        EXPECT_LT((set.list[i].inertia - set.list[i + 1].inertia).norm(), 1e-12 * set.list[i].inertia.norm());
        EXPECT_LT((set.list[i].centre - set.list[i + 1].centre).norm(), 1e-13);
    }
    EXPECT_TRUE(std::ranges::all_of(set.findings.list(), [](const Finding& f) { return f.what.id == "fragments.no_velocity"; }));
}

TEST(FragmentSet, PositionsThatAreNoNumbersAreRefusedByName) {
    ElementScene scene;
    for (int i = 0; i < 4; ++i) {
        scene.element(ElementShape::Hexahedron, cubeAt(2.0 * i), "1110");
    }
    scene.velocity = [](const Vec3&, double) { return Vec3(1, 0, 0); };
    scene.damage = [](std::size_t, FeState& state) {
        state.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
        state.positions[12].z() = std::numeric_limits<double>::infinity();
        state.positions[17].x() = 1e200;
        state.velocities[25].z() = std::numeric_limits<double>::quiet_NaN();
    };
    const FragmentSet set = fragmentsOf(scene);
    ASSERT_EQ(set.size(), 1u);
    EXPECT_EQ(at(set.list[0].element), 3u);
    EXPECT_LT((set.list[0].velocity - Vec3(1, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(set.findings.count("fragments.no_position"), 2);
    EXPECT_EQ(set.findings.count("fragments.out_of_range"), 1);
    EXPECT_EQ(set.findings.count("fragments.part_velocity"), 1);
    EXPECT_EQ(set.findings.list()[0].example, "element 1,001 (rubble) at state 2");
}

TEST(FragmentSet, UnknownVelocityIsRestAndCounted) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube, "1000");
    scene.position = [](const Vec3& x, double t) { return Vec3(x + Vec3::UnitX() * t); };
    const FragmentSet set = fragmentsOf(scene);
    EXPECT_TRUE(set.list[0].velocity.isZero());
    EXPECT_EQ(set.findings.count("fragments.no_velocity"), 1);
}

TEST(FragmentSet, AnElementWithoutDensityIsRefusedWithItsComponent) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube, "10");
    const auto fe = scene.result();
    Components components = ElementScene::components(*fe);
    for (const double density : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        components.density[0] = density;
        try {
            makeFragments(*fe, components, {}, Execution());
            FAIL() << density;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find("rubble"), std::string::npos);
        }
    }
}

TEST(FragmentSet, CancelStopsAndProgressReachesTheEnd) {
    ElementScene scene;
    for (int i = 0; i < 20; ++i) {
        scene.element(ElementShape::Hexahedron, cubeAt(2.0 * i), i < 10 ? "110" : "100");
    }
    const auto fe = scene.result();
    const Components components = ElementScene::components(*fe);
    std::vector<double> fractions;
    makeFragments(*fe, components, {}, Execution([&](const Progress& p) { fractions.push_back(p.fraction); }));
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(makeFragments(*fe, components, {}, cancelled), Cancelled);
}

}  // namespace
}  // namespace rubble
