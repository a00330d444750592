#include "core/fe/components.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

using scenes::Block;
using scenes::makeScene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two blocks of 3 x 1 x 2 cells of 1 m, far apart.
std::shared_ptr<const FeResult> twoBlocks() {
    Block left{.name = "left", .size = {3, 1, 2}, .cells = {3, 1, 2}};
    Block right{.name = "right", .low = {10, 0, 0}, .size = {3, 1, 2}, .cells = {3, 1, 2}, .density = 1000.0};
    return makeScene({left, right}, 2, 1.0);
}

std::vector<std::string> names(const Components& components) {
    std::vector<std::string> result;
    for (const Component& component : components.list) {
        result.push_back(component.name);
    }
    return result;
}

std::vector<std::size_t> sizes(const Components& components) {
    std::vector<std::size_t> result;
    for (const Component& component : components.list) {
        result.push_back(component.elements.size());
    }
    return result;
}

Components grouped(const Mesh& mesh, const std::vector<RegroupStep>& steps) {
    return groupComponents(mesh, steps, {}, {});
}

// What must hold after any regrouping: every element in exactly one component, lists ascending, mass kept.
void expectSound(const Mesh& mesh, const Components& components) {
    std::vector<int> seen(mesh.elementCount(), 0);
    double mass = 0.0;
    for (std::size_t c = 0; c < components.list.size(); ++c) {
        const Component& component = components.list[c];
        EXPECT_TRUE(std::is_sorted(component.elements.begin(), component.elements.end()));
        EXPECT_FALSE(component.elements.empty());
        mass += component.mass;
        for (const ElementIndex e : component.elements) {
            ++seen[at(e)];
            EXPECT_EQ(at(components.of[at(e)]), c);
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                EXPECT_TRUE(component.bounds.contains(mesh.nodes[node]));
            }
        }
    }
    EXPECT_THAT(seen, ::testing::Each(1));
    double expected = 0.0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        expected += components.mass(idAt<ElementIndex>(e));
    }
    EXPECT_NEAR(mass, expected, 1e-12 * expected);
}

TEST(Components, ArePartsOfTheFile) {
    const auto fe = twoBlocks();
    const Components components = grouped(fe->mesh(), {});
    expectSound(fe->mesh(), components);
    EXPECT_THAT(names(components), ElementsAre("left", "right"));
    EXPECT_EQ(components.list[0].kind, "solid");
    EXPECT_NEAR(components.list[0].mass, 6 * 2000.0, 1e-9);
    EXPECT_NEAR(components.list[1].density, 1000.0, 1e-9);
    EXPECT_TRUE(components.list[1].bounds.isApprox(Aabb(Vec3(10, 0, 0), Vec3(13, 1, 2))));
    EXPECT_TRUE(components.findings.empty());
}

TEST(Components, SplitByBoxAndPlaneMoveElementsByTheirCentre) {
    const auto fe = twoBlocks();
    const Components box = grouped(fe->mesh(), {SplitByBox{"left", {-1, -1, 1}, {4, 2, 3}, "left top"}});
    expectSound(fe->mesh(), box);
    EXPECT_THAT(names(box), ElementsAre("left", "left top", "right"));
    EXPECT_THAT(sizes(box), ElementsAre(3u, 3u, 6u));
    EXPECT_NEAR(box.list[1].bounds.min().z(), 1.0, 1e-12);

    const Components plane = grouped(fe->mesh(), {SplitByPlane{"right", {11, 0, 0}, {2, 0, 0}, "right end"}});
    expectSound(fe->mesh(), plane);
    EXPECT_THAT(names(plane), ElementsAre("left", "right", "right end"));
    EXPECT_THAT(sizes(plane), ElementsAre(6u, 2u, 4u));
}

TEST(Components, CornersOfABoxMayBeGivenEitherWayRound) {
    const auto fe = twoBlocks();
    EXPECT_EQ(sizes(grouped(fe->mesh(), {SplitByBox{"left", {4, 2, 3}, {-1, -1, 1}, "top"}})),
              sizes(grouped(fe->mesh(), {SplitByBox{"left", {-1, -1, 1}, {4, 2, 3}, "top"}})));
}

TEST(Components, MergeTakesThePlaceOfTheFirstAndSplitByConnectivityUndoesIt) {
    const auto fe = twoBlocks();
    const Components merged = grouped(fe->mesh(), {MergeComponents{{"right", "left"}, "both"}});
    expectSound(fe->mesh(), merged);
    EXPECT_THAT(names(merged), ElementsAre("both"));
    EXPECT_NEAR(merged.list[0].density, 1500.0, 1e-9);

    const Components split =
        grouped(fe->mesh(), {MergeComponents{{"right", "left"}, "both"}, SplitByBox{"both", {-1, -1, -1}, {1, 2, 3}, "end"},
                             SplitByConnectivity{"both"}, RenameComponent{"both 1", "far"}});
    expectSound(fe->mesh(), split);
    // The larger piece is the right block: two elements of the left one were taken away first.
    EXPECT_THAT(names(split), ElementsAre("far", "both 2", "end"));
    EXPECT_THAT(sizes(split), ElementsAre(6u, 4u, 2u));
    EXPECT_NEAR(split.list[0].bounds.min().x(), 10.0, 1e-12);
}

TEST(Components, AStepThatMovesNothingIsAFinding) {
    const auto fe = twoBlocks();
    const Components components =
        grouped(fe->mesh(), {SplitByBox{"left", {50, 50, 50}, {60, 60, 60}, "nowhere"}, SplitByConnectivity{"right"}});
    EXPECT_THAT(names(components), ElementsAre("left", "right"));
    EXPECT_EQ(components.findings.count("regroup.nothing_moved"), 2);
}

TEST(Components, AStepThatMovesAllRenames) {
    const auto fe = twoBlocks();
    const Components components = grouped(fe->mesh(), {SplitByPlane{"left", {-1, 0, 0}, {1, 0, 0}, "all of it"}});
    EXPECT_THAT(names(components), ElementsAre("all of it", "right"));
}

TEST(Components, UnknownNamesAreErrorsThatNameTheNearest) {
    const auto fe = twoBlocks();
    const std::vector<std::vector<RegroupStep>> wrong{{SplitByConnectivity{"rigth"}},
                                                      {SplitByBox{"rigth", {}, {}, "new"}},
                                                      {SplitByPlane{"rigth", {}, {1, 0, 0}, "new"}},
                                                      {MergeComponents{{"left", "rigth"}, "new"}},
                                                      {RenameComponent{"rigth", "new"}},
                                                      // Gone once it has another name.
                                                      {RenameComponent{"left", "rigth"}, RenameComponent{"left", "new"}}};
    for (const auto& steps : wrong) {
        try {
            grouped(fe->mesh(), steps);
            ADD_FAILURE() << "no error";
        } catch (const UsageError& error) {
            EXPECT_THAT(englishText(error.remedy()), HasSubstr("\"right\""));
        }
    }
    EXPECT_THROW(groupComponents(fe->mesh(), {}, {{"deck", {}}}, {}), UsageError);
}

TEST(Components, NamesMustStayApart) {
    const auto fe = twoBlocks();
    EXPECT_THROW(grouped(fe->mesh(), {RenameComponent{"left", "right"}}), UsageError);
    EXPECT_THROW(grouped(fe->mesh(), {RenameComponent{"left", ""}}), UsageError);
    EXPECT_THROW(grouped(fe->mesh(), {SplitByBox{"left", {}, {1, 1, 1}, "right"}}), UsageError);
    EXPECT_THROW(grouped(fe->mesh(), {MergeComponents{{}, "both"}}), UsageError);
    EXPECT_NO_THROW(grouped(fe->mesh(), {MergeComponents{{"left", "right"}, "left"}}));
    EXPECT_THROW(grouped(fe->mesh(), {SplitByPlane{"left", {}, {0, 0, 0}, "new"}}), UsageError);
}

/// One quadrilateral of 4 m x 2 m in the plane z = 5, one beam of 3 m along x, neither with section nor density.
Mesh shellAndBeam() {
    Mesh mesh;
    mesh.nodes = {{0, 0, 5}, {4, 0, 5}, {4, 2, 5}, {0, 2, 5}, {0, 0, 0}, {3, 0, 0}};
    mesh.nodeIds = {1, 2, 3, 4, 5, 6};
    mesh.elementIds = {10, 11};
    mesh.shapes = {ElementShape::Quadrilateral, ElementShape::Beam};
    mesh.part = {0, 1};
    mesh.offsets = {0, 4, 6};
    mesh.corners = {0, 1, 2, 3, 4, 5};
    mesh.density.assign(2, std::numeric_limits<double>::quiet_NaN());
    mesh.section.assign(2, std::numeric_limits<double>::quiet_NaN());
    mesh.parts = {{"slab", 1}, {"tie", 2}};
    return mesh;
}

TEST(Components, UserOverFileOverAssumptionWhichIsCounted) {
    Mesh mesh = shellAndBeam();
    const MaterialAssumptions assumptions{.density = 2400, .thickness = 0.2, .area = 0.01};
    const Components assumed = groupComponents(mesh, {}, {}, assumptions);
    EXPECT_EQ(assumed.findings.count("components.assumed_density"), 2);
    EXPECT_EQ(assumed.findings.count("components.assumed_thickness"), 1);
    EXPECT_EQ(assumed.findings.count("components.assumed_area"), 1);
    EXPECT_NEAR(assumed.list[0].mass, 8 * 0.2 * 2400, 1e-9);
    EXPECT_NEAR(assumed.list[1].mass, 3 * 0.01 * 2400, 1e-9);

    mesh.density = {7850, -1};
    mesh.section = {0.5, 0.04};
    const Components fromFile = groupComponents(mesh, {}, {}, assumptions);
    EXPECT_NEAR(fromFile.list[0].mass, 8 * 0.5 * 7850, 1e-9);
    EXPECT_EQ(fromFile.findings.count("components.assumed_density"), 1) << "a negative density is none";
    EXPECT_EQ(fromFile.section[1], 0.04);

    const Components fromUser = groupComponents(
        mesh, {RenameComponent{"slab", "deck"}},
        {{"deck", {.density = 1000, .section = 0.1, .structural = false, .material = {}, .reinforced = false}}}, assumptions);
    EXPECT_NEAR(fromUser.list[0].mass, 8 * 0.1 * 1000, 1e-9);
    EXPECT_FALSE(fromUser.list[0].structural);
    EXPECT_TRUE(fromUser.list[1].structural);
}

TEST(Components, BoundsCountThicknessAndSection) {
    const Mesh mesh = shellAndBeam();
    const Components components =
        groupComponents(mesh, {}, {{"slab", {{}, 0.5, {}, {}, false}}, {"tie", {{}, 0.04, {}, {}, false}}}, {});
    EXPECT_TRUE(components.list[0].bounds.isApprox(Aabb(Vec3(0, 0, 4.75), Vec3(4, 2, 5.25)), 1e-12));
    EXPECT_TRUE(components.list[1].bounds.isApprox(Aabb(Vec3(0, -0.1, -0.1), Vec3(3, 0.1, 0.1)), 1e-12));
    const Components merged = groupComponents(mesh, {MergeComponents{{"slab", "tie"}, "all"}}, {}, {});
    EXPECT_EQ(merged.list[0].kind, "mixed");
}

TEST(Components, DensitiesOfOtherUnitsAreNoticed) {
    Mesh mesh = shellAndBeam();
    mesh.density = {2.4e-9, 2400};
    const Components components = groupComponents(mesh, {}, {}, {});
    EXPECT_EQ(components.findings.count("components.implausible_density"), 1);
    // A file in g, cm and microseconds that is read as SI: its 18.6 is tungsten.
    mesh.density = {18.62, 7.896};
    EXPECT_EQ(groupComponents(mesh, {}, {}, {}).findings.count("components.implausible_density"), 2);
}

}  // namespace
}  // namespace rubble
