#include "core/fe/audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

using test::ElementScene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Vec3> cube(double x, double size = 1.0) {
    std::vector<Vec3> corners;
    for (const double z : {0.0, size}) {
        corners.insert(corners.end(), {{x, 0, z}, {x + size, 0, z}, {x + size, size, z}, {x, size, z}});
    }
    return corners;
}

Audit audit(const ElementScene& scene) {
    const auto fe = scene.result();
    return auditDeaths(*fe, ElementScene::components(*fe), Execution{});
}

std::int64_t count(const Audit& audit, std::string_view kind) {
    for (const Anomaly& anomaly : audit.anomalies) {
        if (anomaly.kind == kind) {
            return anomaly.count;
        }
    }
    return 0;
}

TEST(Audit, NoDeathIsAValidAnswer) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(0), "111");
    const Audit result = audit(scene);
    EXPECT_EQ(result.deadTotal, 0);
    EXPECT_THAT(result.deadPerState, ElementsAre(0, 0, 0));
    EXPECT_NEAR(result.mass, 2000.0, 1e-9);
    EXPECT_EQ(result.deadMass, 0.0);
    EXPECT_TRUE(result.anomalies.empty());
}

TEST(Audit, DeadMeansInactiveNowAndActiveBefore) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(0), "11000");
    scene.element(ElementShape::Hexahedron, cube(2), "11101");  // comes back
    scene.element(ElementShape::Hexahedron, cube(4), "00000");  // never there
    scene.element(ElementShape::Hexahedron, cube(6), "00110");  // built later, then dies
    scene.element(ElementShape::Hexahedron, cube(8), "11111");
    const Audit result = audit(scene);
    EXPECT_THAT(result.deadPerState, ElementsAre(0, 0, 1, 2, 2));
    EXPECT_EQ(result.deadTotal, 2);
    EXPECT_NEAR(result.deadMass, 2 * 2000.0, 1e-9);
    EXPECT_EQ(count(result, "inactive_from_start"), 2);
    EXPECT_EQ(count(result, "activated_later"), 1);
    EXPECT_EQ(count(result, "revived"), 1);
    std::int64_t dead = 0;
    for (const ComponentAudit& component : result.components) {
        dead += component.dead;
    }
    EXPECT_EQ(dead, result.deadTotal);
}

TEST(Audit, JudgesTheLastActiveShapeOnly) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(0), "1100");
    // Whatever becomes of the nodes after death is no shape of the element.
    scene.damage = [](std::size_t k, FeState& state) {
        if (k >= 2) {
            state.positions.assign(state.positions.size(), Vec3::Constant(1e6));
        }
    };
    EXPECT_TRUE(audit(scene).anomalies.empty());
    EXPECT_THAT(scene.reads(), ElementsAre(1u)) << "only the state before the death is read";
}

TEST(Audit, CallsBadShapesByTheirKindAndPlace) {
    const auto kinds = [](const std::function<Vec3(const Vec3&)>& deform) {
        ElementScene scene;
        scene.element(ElementShape::Hexahedron, cube(0), "110");
        scene.position = [deform](const Vec3& x, double time) { return time > 0.5 ? deform(x) : x; };
        const Audit result = audit(scene);
        std::vector<std::string> found;
        for (const Anomaly& anomaly : result.anomalies) {
            found.push_back(anomaly.kind);
            EXPECT_THAT(anomaly.example, HasSubstr("at state 1"));
        }
        return found;
    };
    EXPECT_THAT(kinds([](const Vec3& x) { return x; }), ElementsAre());
    EXPECT_THAT(kinds([](const Vec3& x) { return Vec3(x.x(), x.y(), -x.z()); }), ElementsAre("inverted"));
    EXPECT_THAT(kinds([](const Vec3& x) { return Vec3(x.x(), x.y(), 0.0); }), ElementsAre("zero_volume"));
    EXPECT_THAT(kinds([](const Vec3&) { return Vec3(1, 2, 3); }), ElementsAre("zero_volume"));
    EXPECT_THAT(kinds([](const Vec3& x) { return Vec3(2.5 * x.x(), x.y(), x.z()); }), ElementsAre("large_distortion"));
    EXPECT_THAT(kinds([](const Vec3& x) { return Vec3(20 * x.x(), x.y(), 0.05 * x.z()); }), ElementsAre("sliver"));
    EXPECT_THAT(kinds([](const Vec3& x) { return Vec3(1.9 * x.x(), x.y(), x.z()); }), ElementsAre());
}

TEST(Audit, ShellsAndBeamsAreJudgedByAreaAndLength) {
    ElementScene scene;
    scene.element(ElementShape::Quadrilateral, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, "110", 0.001);
    scene.element(ElementShape::Beam, {{0, 0, 5}, {1, 0, 5}}, "110", 1e-6);
    EXPECT_TRUE(audit(scene).anomalies.empty()) << "thin sections are no slivers";
    scene.position = [](const Vec3& x, double time) { return time > 0.5 ? Vec3(3 * x.x(), x.y(), x.z()) : x; };
    EXPECT_EQ(count(audit(scene), "large_distortion"), 2);
}

TEST(Audit, ExactDeathTimesMustLieInTheirBracket) {
    ElementScene scene;
    const double none = std::numeric_limits<double>::quiet_NaN();
    scene.deathTimes = {1.5, 0.7, none, none, 1.0, 2.0000001, 0.3};
    for (int i = 0; i < 6; ++i) {
        scene.element(ElementShape::Hexahedron, cube(2 * i), i == 3 ? "1111" : "1100");
    }
    scene.element(ElementShape::Hexahedron, cube(20), "1111");
    const Audit result = audit(scene);
    EXPECT_EQ(count(result, "death_outside_bracket"), 1) << "0.7 s; the ends of the bracket and single precision pass";
    EXPECT_EQ(count(result, "no_death_time"), 1);
    EXPECT_EQ(count(result, "death_time_of_active"), 1);
}

TEST(Audit, UnknownMaterialIsAnAnomaly) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(0), "11", 0.0, std::numeric_limits<double>::quiet_NaN());
    scene.element(ElementShape::Hexahedron, cube(2), "11");
    EXPECT_EQ(count(audit(scene), "no_density"), 1);
}

TEST(Audit, CanBeCancelled) {
    ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(0), "110");
    const auto fe = scene.result();
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(auditDeaths(*fe, ElementScene::components(*fe), execution), Cancelled);
}

}  // namespace
}  // namespace rubble
