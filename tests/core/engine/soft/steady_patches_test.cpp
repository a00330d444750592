#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/engine/soft/box_contact.h"
#include "core/engine/soft/soft_contact.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

SoftContact contactOf(const Vec3& normal, std::uint32_t feature, double impulse) {
    SoftContact contact;
    contact.normal = normal;
    contact.count = 1;
    contact.points[0].feature = feature;
    contact.points[0].impulse = impulse;
    contact.points[0].push = 0.5 * impulse;
    return contact;
}

/// What a point carries that takes the place of one with an impulse of 10 along z.
SoftContact carried(const Vec3& normal, std::uint32_t feature, bool byAngle) {
    SoftContact contact = contactOf(normal, feature, 0.0);
    carryOver(contactOf(Vec3::UnitZ(), 1, 10.0), contact, byAngle);
    return contact;
}

TEST(SteadyPatches, HandOnWhatActsAlongTheNewNormal) {
    const double half = 0.5, root = std::sqrt(0.75);
    const SoftContact turned = carried(Vec3(root, 0, half), 2, true);
    EXPECT_DOUBLE_EQ(turned.points[0].impulse, 5.0);
    EXPECT_DOUBLE_EQ(turned.points[0].push, 2.5);
    EXPECT_EQ(carried(Vec3(0, 0, -1), 2, true).points[0].impulse, 0.0) << "the other face of a thin plate pushes the other way";
    EXPECT_EQ(carried(Vec3(root, 0, half), 1, true).points[0].impulse, 10.0) << "the same corner that has turned is the same";
    EXPECT_EQ(carried(Vec3(0, 0, -1), 2, false).points[0].impulse, 10.0) << "as before, where trajectories must stay";
}

PlacedBox randomBox(std::mt19937& random, double reach) {
    PlacedBox box;
    std::uniform_real_distribution<double> half(0.2, 1.0), turn(-1.0, 1.0);
    box.centre = test::randomVector(random, reach);
    box.axes = Quat(turn(random), turn(random), turn(random), turn(random)).normalized().toRotationMatrix();
    box.halfExtents = Vec3(half(random), half(random), half(random));
    return box;
}

bool isEdge(const ContactPatch& patch) {
    return patch.count == 1 && patch.points[0].feature >> 8 >= 6 && patch.points[0].feature >> 8 < 15;
}

TEST(SteadyPatches, TakeAFaceThatIsHardlyDeeperThanAnEdge) {
    std::mt19937 random(7);
    int given = 0, kept = 0;
    for (int i = 0; i < 5000; ++i) {
        const PlacedBox a = randomBox(random, 0.5), b = randomBox(random, 0.5);
        const ContactPatch least = collideBoxes(a, b, 0.01), faces = collideBoxes(a, b, 0.01, true);
        if (!isEdge(least) || isEdge(faces)) {
            kept += isEdge(faces);
            EXPECT_EQ(least.normal, faces.normal);
            EXPECT_EQ(least.separation, faces.separation);
            continue;
        }
        ++given;
        const double slack = 0.02 * std::min(a.halfExtents.minCoeff(), b.halfExtents.minCoeff());
        EXPECT_LE(-0.9 * faces.separation, -least.separation + slack + 1e-9) << i;
        EXPECT_GT(faces.count, 0) << i;
    }
    EXPECT_GT(given, 20);
    EXPECT_GT(kept, 20);
}

}  // namespace
}  // namespace rubble
